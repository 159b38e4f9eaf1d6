// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/odometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>

#include "cartographer/transform/se3.h"
#include "test/testing/test_labels.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::Label;
using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabelSet;
using cartographer::transform::Exp;
using cartographer::transform::Rigid3d;
using cartographer::transform::Twist;
using Placement = OdometryReport::Placement;

// What SAGE-ICP does otherwise.
void UseSageIcp(proto::OdometryOptions* options) {
  options->set_mode("semantic_kiss");
  for (auto* const subsampling :
       {options->mutable_map_subsampling(), options->mutable_icp_subsampling()}) {
    proto::ClassVoxels& classes = *subsampling->add_class_voxels();
    classes.add_labels("building");
    classes.set_voxel_size_m(0.8 * subsampling->voxel_size_m());
  }
  options->mutable_local_map()->set_allow_crowding(true);
  options->mutable_local_map()->set_displace_unlabeled(true);
  options->mutable_adaptive_threshold()->set_kernel_sigmas(1. / 3.);
  options->mutable_adaptive_threshold()->set_initial_samples(0);
  options->mutable_icp()->set_weight_by_certainty(false);
  options->mutable_icp()->set_agreeing_distance_factor(0.05);
}

proto::OdometryOptions Options(const std::string& mode) {
  proto::OdometryOptions options;
  options.set_mode(mode);
  options.mutable_preprocessing()->set_max_range_m(100.);
  options.mutable_preprocessing()->set_label_max_range_m(100.);
  options.mutable_preprocessing()->set_deskew(true);
  options.mutable_preprocessing()->set_drop_moving(true);
  for (auto* const subsampling :
       {options.mutable_map_subsampling(), options.mutable_icp_subsampling()}) {
    subsampling->set_max_points_per_voxel(1);
    subsampling->set_max_critical_points_per_voxel(20);
  }
  options.mutable_map_subsampling()->set_voxel_size_m(0.5);
  options.mutable_icp_subsampling()->set_voxel_size_m(1.5);
  options.mutable_local_map()->set_voxel_size_m(1.);
  options.mutable_local_map()->set_max_points_per_voxel(20);
  options.mutable_local_map()->set_max_critical_points_per_voxel(20);
  options.mutable_adaptive_threshold()->set_initial_m(2.);
  options.mutable_adaptive_threshold()->set_min_model_error_m(0.1);
  options.mutable_adaptive_threshold()->set_gate_sigmas(3.);
  options.mutable_adaptive_threshold()->set_kernel_sigmas(1.);
  options.mutable_adaptive_threshold()->set_initial_samples(1);
  auto* const icp = options.mutable_icp();
  icp->set_max_iterations(500);
  icp->set_convergence_threshold(1e-4);
  icp->set_min_points(10);
  icp->set_min_correspondences(10);
  icp->set_weight_by_certainty(true);
  icp->set_unlabeled_weight(1.);
  icp->set_min_lever_arm_m(0.1);
  icp->set_agreeing_distance_factor(1.);
  options.set_restart_after_failures(3);
  if (mode == "sage_icp") UseSageIcp(&options);
  return options;
}

// A street of 80 m by 16 m with house fronts that are not flat and poles, in its own frame, seen
// from `street_from_sensor`. Points are a fixed set, thinned at random by scan, so that scans
// differ.
LabeledPointCloud SeeStreet(const LabelSet& labels, const Rigid3d& street_from_sensor, int seed) {
  const Label building = *labels.FromName("building"), pole = *labels.FromName("pole");
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.f, 1.f);
  LabeledPointCloud cloud;
  const Rigid3d sensor_from_street = street_from_sensor.inverse();
  const auto add = [&](double x, double y, double z, Label label) {
    if (uniform(random) < 0.3f) return;
    cloud.positions.push_back((sensor_from_street * Eigen::Vector3d(x, y, z)).cast<float>());
    cloud.labels.push_back(label);
    cloud.certainties.push_back(0.9f);
  };
  for (double x = -40.; x < 40.; x += 0.25) {
    const double depth = std::sin(x) + 0.5 * std::sin(3.7 * x);
    for (double z = 0.; z < 6.; z += 0.5) {
      add(x, 8. + depth, z, building);
      add(x, -8. - depth, z, building);
    }
    for (double y = -7.; y < 7.; y += 0.5) add(x, y, 0.05 * std::sin(x + y), building);
  }
  for (double x = -35.; x < 40.; x += 15.) {
    for (double z = 0.; z < 4.; z += 0.1) add(x, 5., z, pole);
  }
  return cloud;
}

double DistanceFrom(const Rigid3d& expected, const Rigid3d& actual) {
  return (expected.inverse() * actual).translation().norm();
}

class OdometryModeTest : public testing::TestWithParam<std::string> {};

TEST_P(OdometryModeTest, FollowsACurvedDrive) {
  const LabelSet labels = semantic_kiss_testing::SomeKittiLabels();
  Odometry odometry(Options(GetParam()), labels);
  Twist step;
  step << 0.5, 0., 0., 0., 0., 0.01;
  const Rigid3d street_from_start = Rigid3d::Translation({-10., 0., 1.7});
  Rigid3d start_from_sensor;
  for (int scan = 0; scan < 20; ++scan) {
    const OdometryReport report =
        odometry.AddScan(SeeStreet(labels, street_from_start * start_from_sensor, scan));
    EXPECT_EQ(OutcomeName(report), scan == 0 ? "first" : "converged");
    EXPECT_LT(DistanceFrom(start_from_sensor, report.local_from_sensor), 0.1) << scan;
    start_from_sensor = start_from_sensor * Exp(step);
  }
}

TEST_P(OdometryModeTest, BadScansAreSurvivedByTheMotionModel) {
  const LabelSet labels = semantic_kiss_testing::SomeKittiLabels();
  Odometry odometry(Options(GetParam()), labels);
  const Rigid3d street_from_start = Rigid3d::Translation({-10., 0., 1.7});
  Twist step = Twist::Zero();
  step[0] = 0.5;
  Rigid3d start_from_sensor;
  for (int scan = 0; scan < 10; ++scan) {
    LabeledPointCloud cloud = SeeStreet(labels, street_from_start * start_from_sensor, scan);
    std::string expected = scan == 0 ? "first" : "converged";
    if (scan == 5) {
      cloud = LabeledPointCloud();
      expected = "too_few_points";
    }
    if (scan == 6) {
      for (Eigen::Vector3f& position : cloud.positions) {
        position.x() = std::numeric_limits<float>::quiet_NaN();
      }
      expected = "too_few_points";
    }
    const OdometryReport report = odometry.AddScan(cloud);
    EXPECT_EQ(OutcomeName(report), expected) << scan;
    EXPECT_EQ(report.placement == Placement::kPredicted, expected == "too_few_points");
    EXPECT_TRUE(report.local_from_sensor.IsFinite());
    EXPECT_LT(DistanceFrom(start_from_sensor, report.local_from_sensor), 0.1) << scan;
    start_from_sensor = start_from_sensor * Exp(step);
  }
}

TEST_P(OdometryModeTest, BeginsAnewAfterTooManyFailures) {
  const LabelSet labels = semantic_kiss_testing::SomeKittiLabels();
  Odometry odometry(Options(GetParam()), labels);
  const Rigid3d street_from_sensor = Rigid3d::Translation({0., 0., 1.7});
  LabeledPointCloud here = SeeStreet(labels, street_from_sensor, 1);
  odometry.AddScan(here);
  // The same street, but nowhere near what the map holds.
  LabeledPointCloud elsewhere = here;
  for (Eigen::Vector3f& position : elsewhere.positions) position.z() += 40.f;
  EXPECT_EQ(OutcomeName(odometry.AddScan(elsewhere)), "no_correspondences");
  EXPECT_EQ(OutcomeName(odometry.AddScan(elsewhere)), "no_correspondences");
  EXPECT_EQ(OutcomeName(odometry.AddScan(elsewhere)), "restarted");
  const OdometryReport report = odometry.AddScan(elsewhere);
  EXPECT_EQ(OutcomeName(report), "converged");
  EXPECT_LT(DistanceFrom(Rigid3d(), report.local_from_sensor), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Modes, OdometryModeTest,
                         testing::Values("semantic_kiss", "kiss_icp", "sage_icp"));

TEST(OdometryTest, MovingThingsAreDroppedOnlyWithLabels) {
  const LabelSet labels = semantic_kiss_testing::SomeKittiLabels();
  LabeledPointCloud cloud = SeeStreet(labels, Rigid3d::Translation({0., 0., 1.7}), 1);
  const Label moving_car = *labels.FromName("moving-car");
  for (size_t i = 0; i < 100; ++i) cloud.labels[i] = moving_car;
  const OdometryReport semantic = Odometry(Options("semantic_kiss"), labels).AddScan(cloud);
  EXPECT_EQ(semantic.counts.moving, 100);
  EXPECT_EQ(std::count(semantic.points.labels.begin(), semantic.points.labels.end(), moving_car),
            0);
  const OdometryReport plain = Odometry(Options("kiss_icp"), labels).AddScan(cloud);
  EXPECT_EQ(plain.counts.moving, 0);
  EXPECT_EQ(plain.points.size(), cloud.size());
}

TEST(OdometryTest, KissIcpModeIsDeafToLabels) {
  const LabelSet labels = semantic_kiss_testing::SomeKittiLabels();
  Odometry labeled(Options("kiss_icp"), labels), unlabeled(Options("kiss_icp"), LabelSet());
  Twist step = Twist::Zero();
  step[0] = 0.4;
  Rigid3d street_from_sensor = Rigid3d::Translation({-10., 0., 1.7});
  for (int scan = 0; scan < 5; ++scan) {
    LabeledPointCloud cloud = SeeStreet(labels, street_from_sensor, scan);
    const OdometryReport with = labeled.AddScan(cloud);
    std::fill(cloud.labels.begin(), cloud.labels.end(), cartographer::sensor::kUnlabeled);
    const OdometryReport without = unlabeled.AddScan(cloud);
    EXPECT_EQ(with.local_from_sensor.Matrix(), without.local_from_sensor.Matrix());
    street_from_sensor = street_from_sensor * Exp(step);
  }
}

TEST(OdometryTest, UnlabeledScansMakeSemanticModeKissIcp) {
  const LabelSet labels = semantic_kiss_testing::SomeKittiLabels();
  Odometry semantic(Options("semantic_kiss"), labels), plain(Options("kiss_icp"), labels);
  Twist step = Twist::Zero();
  step[0] = 0.4;
  Rigid3d street_from_sensor = Rigid3d::Translation({-10., 0., 1.7});
  for (int scan = 0; scan < 5; ++scan) {
    LabeledPointCloud cloud = SeeStreet(labels, street_from_sensor, scan);
    std::fill(cloud.labels.begin(), cloud.labels.end(), cartographer::sensor::kUnlabeled);
    EXPECT_EQ(semantic.AddScan(cloud).local_from_sensor.Matrix(),
              plain.AddScan(cloud).local_from_sensor.Matrix());
    street_from_sensor = street_from_sensor * Exp(step);
  }
}

}  // namespace
}  // namespace semantic_kiss::odometry
