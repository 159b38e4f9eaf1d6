// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/trace_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "absl/strings/str_split.h"
#include "test/testing/test_labels.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::sensor::Label;
using cartographer::slam::TraceStep;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Reading gives points of as many labels as there are, one of the first, two of the second, ...
TracedScan Traced() {
  TracedScan traced;
  traced.number = 120;
  TraceStep reading{"reading", "sensor", "as the files have it"};
  reading.Gives(36).Took(0.0012);
  for (uint8_t i = 0; i < 8; ++i) reading.labels[Label{i}] = i + 1;
  traced.steps.push_back(reading);
  TraceStep range{"range", "sensor",
                  "some words that say what became of the points, so many that "
                  "they need another line even on the widest terminal"};
  traced.steps.push_back(range.Takes("reading", 36).Gives(30));
  traced.steps.push_back({"place", "map", "here"});
  return traced;
}

TEST(TraceTextTest, IsATable) {
  const auto labels = semantic_kiss_testing::SomeKittiLabels();
  const std::string text = TraceText(Traced(), labels, Terminal{false, false, 80});
  const std::vector<std::string> lines = absl::StrSplit(text, '\n');
  EXPECT_EQ(lines[0], "The way of scan 120");
  EXPECT_EQ(lines[2], "  reading        sensor          -       36     1.20 as the files have it");
  // The commonest labels first; the two rarest are only counted.
  EXPECT_THAT(lines[3], StartsWith("    " + labels.Name(Label{7}) + " 8, "));
  EXPECT_THAT(lines[3], HasSubstr(", 2 more"));
  EXPECT_THAT(lines[4], StartsWith("  range          sensor         36       30        \" some"));
  EXPECT_THAT(lines[5], StartsWith(std::string(53, ' ') + "need another line even"));
  for (const std::string& line : lines) EXPECT_LE(line.size(), 120u);
}

TEST(TraceTextTest, FitsNarrowTerminals) {
  const auto labels = semantic_kiss_testing::SomeKittiLabels();
  const std::string text = TraceText(Traced(), labels, Terminal{true, false, 90});
  for (const auto line : absl::StrSplit(text, '\n')) EXPECT_LE(line.size(), 90u) << line;
}

TEST(TraceTextTest, JsonHasWhatScriptsRelyOn) {
  const auto json = TraceJson(Traced(), semantic_kiss_testing::SomeKittiLabels());
  EXPECT_EQ(json["scan"], 120);
  EXPECT_EQ(json["steps"].size(), 3u);
  EXPECT_EQ(json["steps"][0]["labels"].size(), 8u);
  EXPECT_TRUE(json["steps"][0]["points_in"].is_null());
  EXPECT_DOUBLE_EQ(json["steps"][0]["ms"].get<double>(), 1.2);
  EXPECT_EQ(json["steps"][1]["from"], "reading");
  EXPECT_EQ(json["steps"][1]["points_out"], 30);
  EXPECT_TRUE(json["steps"][2]["labels"].empty());
  EXPECT_TRUE(json["steps"][2]["ms"].is_null());
}

}  // namespace
}  // namespace semantic_kiss::cli
