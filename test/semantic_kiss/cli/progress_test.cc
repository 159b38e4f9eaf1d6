// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace semantic_kiss::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Progress Halfway() { return {2270, 4540, 100., 0.428}; }

TEST(ProgressBarTest, ShowsAllWhereThereIsRoom) {
  EXPECT_EQ(ProgressBar(Halfway(), 100),
            "[===================                   ]  50% 2270/4540 ETA 1:40 22.7/s odometry off "
            "by 0.43 m");
}

TEST(ProgressBarTest, FitsEveryWidthAndKeepsTheMostImportant) {
  for (int width = 1; width <= 200; ++width) {
    const std::string bar = ProgressBar(Halfway(), width);
    EXPECT_LT(bar.size(), width) << bar;
    if (width < 6) continue;
    EXPECT_THAT(bar, HasSubstr("50%")) << width;
  }
  EXPECT_EQ(ProgressBar(Halfway(), 40), " 50% 2270/4540 ETA 1:40 22.7/s");
}

TEST(ProgressBarTest, SurvivesTheBeginningAndAnEmptyJob) {
  EXPECT_THAT(ProgressBar({0, 10, 0., std::nullopt}, 80), HasSubstr("ETA ?"));
  EXPECT_THAT(ProgressBar({0, 0, 0., std::nullopt}, 80), HasSubstr("100%"));
}

TEST(ProgressLineTest, CountsHoursAndShowsNoErrorWithoutGroundTruth) {
  const std::string line = ProgressLine({1, 7201, 1., std::nullopt});
  EXPECT_EQ(line, "1/7201 scans, 1.0 scans/s, 2:00:00 left");
}

// A clock that a test advances by hand.
class ProgressReporterTest : public ::testing::Test {
 protected:
  ProgressReporter Reporter(ProgressReporter::Mode mode) {
    return ProgressReporter(
        mode, Terminal{true, false, 60}, 100, [this] { return now_s_; }, &out_);
  }
  double now_s_ = 0.;
  std::ostringstream out_;
};

TEST_F(ProgressReporterTest, SilentPrintsNothing) {
  ProgressReporter reporter = Reporter(ProgressReporter::Mode::kSilent);
  now_s_ = 60.;
  reporter.Update(50, 1.);
  reporter.Finish();
  EXPECT_EQ(out_.str(), "");
}

TEST_F(ProgressReporterTest, LinesComeNowAndThenAndAtTheEnd) {
  ProgressReporter reporter = Reporter(ProgressReporter::Mode::kLines);
  for (int scan = 1; scan <= 100; ++scan) {
    now_s_ += 0.1;
    reporter.Update(scan, std::nullopt);
  }
  reporter.Finish();
  const std::string text = out_.str();
  EXPECT_GE(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_THAT(text, HasSubstr("100/100 scans, 10.0 scans/s, 0:00 left\n"));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

TEST_F(ProgressReporterTest, ABarOverwritesItselfAndEndsItsLine) {
  ProgressReporter reporter = Reporter(ProgressReporter::Mode::kBar);
  now_s_ = 1.;
  reporter.Update(10, std::nullopt);
  now_s_ = 1.01;
  reporter.Update(11, std::nullopt);
  EXPECT_THAT(out_.str(), HasSubstr("10/100"));
  EXPECT_THAT(out_.str(), Not(HasSubstr("11/100"))) << "too soon after the last";
  reporter.Finish();
  EXPECT_THAT(out_.str(), HasSubstr("11/100"));
  EXPECT_EQ(out_.str().front(), '\r');
  EXPECT_EQ(out_.str().back(), '\n');
}

TEST_F(ProgressReporterTest, AnnouncesUnderABarAndTakesItBack) {
  {
    ProgressReporter reporter = Reporter(ProgressReporter::Mode::kBar);
    reporter.Update(100, std::nullopt);
    reporter.Finish();
    out_.str("");
    reporter.Announce("first");
    reporter.Announce("second");
    EXPECT_EQ(out_.str(), "\rfirst\033[K\rsecond\033[K");
    out_.str("");
  }
  EXPECT_EQ(out_.str(), "\r\033[K");
  out_.str("");
  Reporter(ProgressReporter::Mode::kLines).Announce("nothing in logs");
  EXPECT_EQ(out_.str(), "");
}

TEST_F(ProgressReporterTest, ABarThatIsCutShortEndsItsLine) {
  {
    ProgressReporter reporter = Reporter(ProgressReporter::Mode::kBar);
    now_s_ = 1.;
    reporter.Update(10, std::nullopt);
  }
  EXPECT_EQ(out_.str().back(), '\n');
}

}  // namespace
}  // namespace semantic_kiss::cli
