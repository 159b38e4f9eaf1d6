// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// Reads the excerpts of KITTI and SemanticKITTI that are kept beside the source tree, with the
// configuration that is shipped.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cartographer/common/options_loader.h"
#include "cartographer/io/trajectory_files.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/dataset/prefetching_scan_source.h"
#include "semantic_kiss/dataset/scan_times.h"
#include "semantic_kiss/dataset/semantic_kitti_source.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::common::LoadOptions;
using cartographer::common::LoadOptionsFromString;
using cartographer::common::ToUnixSeconds;
using cartographer::sensor::Label;
using cartographer::sensor::LabeledScan;
using cartographer::sensor::LabelSet;
using cartographer::transform::Rigid3d;
using semantic_kiss_testing::RealDataDirectory;
using semantic_kiss_testing::SourceFile;
using ::testing::IsEmpty;

LabelSet ShippedLabels() {
  cartographer::sensor::proto::LabelSet declaration;
  const absl::Status status =
      LoadOptions({SourceFile("configuration_files/labels/semantic_kitti.lua"), {}}, &declaration);
  EXPECT_TRUE(status.ok()) << status;
  return LabelSet::Create(declaration).value();
}

class RealScansTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::optional<std::string> data = RealDataDirectory();
    if (!data.has_value()) GTEST_SKIP();
    data_ = *data;
    const absl::Status status =
        LoadOptionsFromString("include \"defaults/dataset.lua\"\nreturn DATASET", "test",
                              {SourceFile("configuration_files")}, &options_);
    ASSERT_TRUE(status.ok()) << status;
  }

  std::unique_ptr<ScanSource> Open(const std::string& directory) {
    const SemanticKittiLocation location{data_ + "/" + directory, "00", ""};
    return OpenSemanticKitti(location, {}, options_, labels_).value();
  }

  int NumPoints(const LabeledScan& scan, const char* name) const {
    const std::vector<Label>& labels = scan.points.labels;
    return std::count(labels.begin(), labels.end(), labels_.FromName(name).value());
  }

  std::string data_;
  proto::DatasetOptions options_;
  const LabelSet labels_ = ShippedLabels();
};

// Counted apart from this reader: points, and points with the label 255.
struct ExpectedScan {
  size_t num_points;
  int num_motorcyclist;
};
constexpr ExpectedScan kLabeledScans[] = {{124668, 88}, {124605, 73}, {124478, 72}, {124167, 71},
                                          {123969, 72}, {123924, 70}, {123373, 69}, {122765, 69},
                                          {122123, 86}, {121357, 97}, {121018, 86}, {120945, 79},
                                          {120503, 76}, {120295, 73}, {120406, 57}, {121023, 68}};

TEST_F(RealScansTest, SixteenLabeledScans) {
  PrefetchingScanSource source(Open("semantickitti"));
  ASSERT_EQ(source.size(), 16);
  double last_time = -1.;
  for (int i = 0; i < source.size(); ++i) {
    const LabeledScan scan = source.Read(i).value();
    scan.points.CheckConsistent();
    EXPECT_EQ(scan.index, i);
    EXPECT_GT(ToUnixSeconds(scan.time), last_time);
    last_time = ToUnixSeconds(scan.time);
    EXPECT_EQ(scan.points.size(), kLabeledScans[i].num_points);
    const auto& certainties = scan.points.certainties;
    EXPECT_EQ(std::count(certainties.begin(), certainties.end(), 0.9f), certainties.size());
    EXPECT_EQ(NumPoints(scan, "moving-motorcyclist"), kLabeledScans[i].num_motorcyclist);
    for (const char* name : {"road", "sidewalk", "building", "car", "vegetation"}) {
      EXPECT_GT(NumPoints(scan, name), 1000) << name;
    }
  }
  EXPECT_NEAR(last_time, 1.5555, 0.01);
  EXPECT_THAT(source.unknown_label_ids(), IsEmpty());
}

TEST_F(RealScansTest, GroundTruthDrivesForward) {
  const std::unique_ptr<ScanSource> source = Open("semantickitti");
  ASSERT_TRUE(source->ground_truth().has_value());
  const std::vector<Rigid3d>& poses = *source->ground_truth();
  ASSERT_EQ(poses.size(), 16);
  EXPECT_LT((poses[0].Matrix() - Rigid3d().Matrix()).norm(), 1e-5);
  // As the car drives, x of the lidar is ahead.
  EXPECT_NEAR(poses.back().translation().x(), 12.9, 0.2);
  EXPECT_LT(std::abs(poses.back().translation().y()), 1.);
  EXPECT_LT(std::abs(poses.back().translation().z()), 1.);
}

// A fact about KITTI rather than the reader: on a flat road the ground, seen up to 25 m, comes out
// more level with the correction, which the sign of the angle decides.
TEST_F(RealScansTest, CorrectionLevelsTheRoad) {
  const Label road = labels_.FromName("road").value();
  double height_difference_m[2];  // of the road ahead and behind, far against near
  for (const bool corrected : {false, true}) {
    options_.set_vertical_correction_deg(corrected ? 0.205 : 0.);
    const LabeledScan scan = Open("semantickitti")->Read(0).value();
    double sum[2] = {0., 0.};
    int count[2] = {0, 0};
    for (size_t i = 0; i < scan.points.size(); ++i) {
      if (scan.points.labels[i] != road) continue;
      const double range_m = scan.points.positions[i].head<2>().norm();
      const bool far = range_m > 15.;
      if (range_m > 25. || (!far && range_m > 8.)) continue;
      sum[far] += scan.points.positions[i].z();
      ++count[far];
    }
    height_difference_m[corrected] = sum[1] / count[1] - sum[0] / count[0];
  }
  // About 13 m farther by 0.205 degrees.
  EXPECT_NEAR(height_difference_m[1] - height_difference_m[0], 0.045, 0.01);
}

TEST_F(RealScansTest, UnlabeledSequences) {
  const std::map<std::string, int> num_scans = {
      {"kitti_raw/drive_0002", 10}, {"kitti_raw/city_22", 22}, {"kitti_raw/standstill", 4}};
  for (const auto& [name, expected] : num_scans) {
    const std::unique_ptr<ScanSource> source = Open(name);
    ASSERT_EQ(source->size(), expected) << name;
    EXPECT_EQ(source->ground_truth().has_value(), name == "kitti_raw/drive_0002");
    const LabeledScan scan = source->Read(expected - 1).value();
    scan.points.CheckConsistent();
    EXPECT_GT(scan.points.size(), 100000) << name;
    EXPECT_EQ(NumPoints(scan, "unlabeled"), scan.points.size());
  }
}

// Every trajectory of the odometry benchmark with its times and calibration.
TEST_F(RealScansTest, TimesOfTheElevenSequences) {
  for (int sequence = 0; sequence <= 10; ++sequence) {
    const std::string name = (sequence < 10 ? "0" : "") + std::to_string(sequence) + ".txt";
    const auto times = ReadScanTimes(data_ + "/kitti_odometry/times/" + name);
    const auto poses = cartographer::io::ReadKittiPoses(data_ + "/kitti_odometry/poses/" + name);
    ASSERT_TRUE(times.ok()) << times.status();
    ASSERT_TRUE(poses.ok()) << poses.status();
    EXPECT_EQ(times->size(), poses->size()) << name;
  }
}

}  // namespace
}  // namespace semantic_kiss::dataset
