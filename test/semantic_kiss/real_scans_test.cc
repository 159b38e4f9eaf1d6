// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// The odometry on real scans, against the poses of upstream KISS-ICP and against SemanticKITTI's.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/odometry/odometry.h"
#include "test/testing/odometry_on_sequence.h"
#include "test/testing/test_files.h"

namespace semantic_kiss {
namespace {

using cartographer::transform::Rigid3d;

constexpr char kKissIcp[] = "options.odometry.mode = 'kiss_icp'";

std::vector<Rigid3d> PosesOf(const std::string& directory, const std::string& overrides) {
  const auto options = semantic_kiss_testing::ShippedOptions(overrides);
  odometry::Odometry odometry(options.odometry(), semantic_kiss_testing::ShippedLabels());
  std::vector<Rigid3d> poses;
  for (const auto& scan : semantic_kiss_testing::ReadScans(directory)) {
    poses.push_back(odometry.AddScan(scan.points).local_from_sensor);
  }
  return poses;
}

struct Difference {
  double translation_m = 0.;
  double rotation_deg = 0.;
};

Difference Compare(const Rigid3d& a, const Rigid3d& b) {
  const Rigid3d difference = a.inverse() * b;
  return {difference.translation().norm(),
          cartographer::transform::RotationAngle(difference) * 180. / M_PI};
}

// A test that needs the real data asks for its directory first.
#define SKIP_WITHOUT_REAL_DATA(data)                            \
  const auto data = semantic_kiss_testing::RealDataDirectory(); \
  if (!data.has_value()) GTEST_SKIP() << "needs the real scans, which are not here"

TEST(RealScansTest, KissIcpModeHasThePosesOfKissIcp) {
  SKIP_WITHOUT_REAL_DATA(data);
  const std::pair<std::string, std::string> sequences[] = {{"semantickitti", "semantickitti_00"},
                                                           {"kitti_raw/city_22", "city_22"},
                                                           {"kitti_raw/drive_0002", "drive_0002"},
                                                           {"kitti_raw/standstill", "standstill"}};
  for (const auto& [directory, name] : sequences) {
    const auto reference =
        cartographer::io::ReadKittiPoses(*data + "/reference/kiss_icp/" + name + ".txt");
    ASSERT_TRUE(reference.ok()) << reference.status();
    const std::vector<Rigid3d> poses = PosesOf(*data + "/" + directory, kKissIcp);
    ASSERT_EQ(poses.size(), reference->size());
    for (size_t i = 0; i < poses.size(); ++i) {
      const Difference difference = Compare((*reference)[i], poses[i]);
      // Where they differ it is by rounding: they keep doubles, we floats.
      EXPECT_LT(difference.translation_m, 0.001) << name << ", scan " << i;
      EXPECT_LT(difference.rotation_deg, 0.005) << name << ", scan " << i;
    }
  }
}

TEST(RealScansTest, AStandingCarStands) {
  SKIP_WITHOUT_REAL_DATA(data);
  for (const std::string& overrides : {std::string(kKissIcp), std::string()}) {
    for (const Rigid3d& pose : PosesOf(*data + "/kitti_raw/standstill", overrides)) {
      EXPECT_LT(pose.translation().norm(), 0.01);
    }
  }
}

TEST(RealScansTest, LabelsBringTheLastPoseCloser) {
  SKIP_WITHOUT_REAL_DATA(data);
  const std::string sequence = *data + "/semantickitti/sequences/00/";
  const auto cam_from_lidar = cartographer::io::ReadKittiCalibration(sequence + "calib.txt");
  const auto cam_poses = cartographer::io::ReadKittiPoses(sequence + "poses_semantickitti.txt");
  ASSERT_TRUE(cam_from_lidar.ok()) << cam_from_lidar.status();
  ASSERT_TRUE(cam_poses.ok()) << cam_poses.status();
  const auto truth = [&](size_t scan) {
    return cam_from_lidar->inverse() * (*cam_poses)[scan] * *cam_from_lidar;
  };
  const auto last_error = [&](const std::string& overrides) {
    const std::vector<Rigid3d> poses = PosesOf(*data + "/semantickitti", overrides);
    return Compare(truth(0).inverse() * truth(poses.size() - 1), poses.back()).translation_m;
  };
  const double plain_m = last_error(kKissIcp);
  const double semantic_m = last_error("");
  EXPECT_LT(plain_m, 0.106);  // upstream's own is 0.105 m
  EXPECT_LT(semantic_m, 0.085);
  EXPECT_LT(semantic_m, plain_m);
}

}  // namespace
}  // namespace semantic_kiss
