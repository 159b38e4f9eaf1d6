// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/point_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "test/testing/test_files.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::sensor::LabeledPointCloud;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using semantic_kiss_testing::WriteValues;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PointFileTest : public ::testing::Test {
 protected:
  std::string ErrorOfPoints() {
    return std::string(ReadPoints(path_, &buffer_, &cloud_).message());
  }
  std::string ErrorOfTimes(size_t num_points) {
    return std::string(ReadPointTimes(path_, num_points, &buffer_, &times_).message());
  }

  const TemporaryDirectory directory_;
  const std::string path_ = directory_ / "000007.bin";
  FileBuffer buffer_;
  LabeledPointCloud cloud_;
  std::vector<float> times_;
};

TEST_F(PointFileTest, SplitsRowsIntoColumns) {
  WriteValues<float>(path_, {1.f, 2.f, 3.f, 0.4f, -5.f, 6.f, -7.f, 0.8f});
  ASSERT_TRUE(ReadPoints(path_, &buffer_, &cloud_).ok());
  EXPECT_THAT(cloud_.positions,
              ElementsAre(Eigen::Vector3f(1.f, 2.f, 3.f), Eigen::Vector3f(-5.f, 6.f, -7.f)));
  EXPECT_THAT(cloud_.intensities, ElementsAre(0.4f, 0.8f));
}

TEST_F(PointFileTest, AnEmptyFileIsAScanWithoutPoints) {
  cloud_.positions.resize(5);
  WriteText(path_, "");
  ASSERT_TRUE(ReadPoints(path_, &buffer_, &cloud_).ok());
  EXPECT_TRUE(cloud_.empty());
}

TEST_F(PointFileTest, KeepsValuesThatAreNotFinite) {
  WriteValues<float>(path_, {NAN, INFINITY, 3.f, -INFINITY});
  ASSERT_TRUE(ReadPoints(path_, &buffer_, &cloud_).ok());
  EXPECT_TRUE(std::isnan(cloud_.positions[0].x()));
  EXPECT_EQ(cloud_.positions[0].y(), INFINITY);
  EXPECT_EQ(cloud_.intensities[0], -INFINITY);
}

TEST_F(PointFileTest, EveryCutThatIsNoWholePointIsAnError) {
  WriteValues<float>(path_, std::vector<float>(8, 1.f));
  for (int size = 0; size <= 32; ++size) {
    WriteText(path_, std::string(size, 'x'));
    EXPECT_EQ(ReadPoints(path_, &buffer_, &cloud_).ok(), size % 16 == 0) << size;
  }
  WriteText(path_, std::string(17, 'x'));
  EXPECT_EQ(ErrorOfPoints(),
            path_ +
                ": size is 17 bytes, not a multiple of 16; points are float32 x, y, z, remission. "
                "Is the file cut off, or another format?");
}

TEST_F(PointFileTest, ReadsTimesOfPoints) {
  WriteValues<float>(path_, {-0.1f, -0.05f, 0.f});
  ASSERT_TRUE(ReadPointTimes(path_, 3, &buffer_, &times_).ok());
  EXPECT_THAT(times_, ElementsAre(-0.1f, -0.05f, 0.f));
}

TEST_F(PointFileTest, NeedsATimeForEveryPoint) {
  WriteValues<float>(path_, {-0.1f, 0.f});
  EXPECT_EQ(ErrorOfTimes(3),
            path_ + ": size is 8 bytes; for a scan of 3 points it is 12, a float32 a point");
}

TEST_F(PointFileTest, RefusesTimesInAnotherUnitOrFromAnotherOrigin) {
  for (const float time : {0.05f, -50.f, NAN, -INFINITY}) {
    WriteValues<float>(path_, {-0.1f, time});
    EXPECT_THAT(ErrorOfTimes(2), HasSubstr(path_ + ": time of point 1 is ")) << time;
    EXPECT_THAT(ErrorOfTimes(2), HasSubstr("not in [-1, 0]")) << time;
  }
}

}  // namespace
}  // namespace semantic_kiss::dataset
