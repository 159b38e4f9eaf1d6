// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/odometry_chain.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "test/cartographer/pose_graph/made_up_drive.h"

namespace cartographer::pose_graph {
namespace {

using transform::Exp;
using transform::Log;
using transform::Matrix6d;
using transform::Rigid3d;
using transform::Twist;

proto::OdometryErrorOptions Options() {
  return OptimizationDefaults(R"(
      local function sigmas(m, up, t, y)
        return { forward_m = m, left_m = m, up_m = up, tilt_deg = t, heading_deg = y }
      end
      OPTIMIZATION.odometry = { random = sigmas(0.02, 0.03, 0.1, 0.2), min_step_m = 0.1,
                                systematic = sigmas(0, 0, 0, 0) })")
      .odometry();
}

double Difference(const Rigid3d& a, const Rigid3d& b) { return (a.Matrix() - b.Matrix()).norm(); }

Graph GraphOf(const Poses& poses) {
  Graph graph;
  AddTrajectory(3, poses, &graph);
  return graph;
}

TEST(OdometryChainTest, SigmasAreInMetresAndRadians) {
  Twist expected;
  const double degree = M_PI / 180.;
  expected << 0.02, 0.02, 0.03, 0.1 * degree, 0.1 * degree, 0.2 * degree;
  EXPECT_LT((ToTwist(Options().random()) - expected).norm(), 1e-15);
  EXPECT_EQ(PositiveSigmas(Options().systematic()), Twist::Constant(1e-6));
}

TEST(OdometryChainTest, TakesTheNodesOfItsTrajectoryInOrder) {
  const Poses poses = Laps(0.1);
  Graph graph = GraphOf(poses);
  AddTrajectory(2, Laps(0.2), &graph);
  AddTrajectory(4, Laps(0.2), &graph);
  graph.nodes.erase(submap::NodeId{3, 5});
  const OdometryChain chain(Options(), graph, 3);
  ASSERT_EQ(chain.size(), static_cast<int>(poses.size()) - 1);
  EXPECT_EQ(chain.id(5), (submap::NodeId{3, 6}));
  EXPECT_EQ(chain.IndexOf({3, 6}), 5);
  EXPECT_EQ(chain.distance_m(0), 0.);
  EXPECT_NEAR(chain.distance_m(1), (poses[1].translation() - poses[0].translation()).norm(), 1e-12);
}

TEST(OdometryChainTest, OneStepIsAsTheOptionsSay) {
  const Graph graph = GraphOf(Laps(0.1));
  const OdometryChain chain(Options(), graph, 3);
  const OdometrySegment step = chain.Between(4, 5);
  const double length_m = chain.distance_m(5) - chain.distance_m(4);
  EXPECT_LT((step.drift - length_m * Matrix6d::Identity()).norm(), 1e-12);
  const Matrix6d covariance = (length_m * ToTwist(Options().random()).cwiseAbs2()).asDiagonal();
  EXPECT_LT((step.covariance - covariance).norm(), 1e-15);
}

TEST(OdometryChainTest, StandingStillIsUncertainToo) {
  const Graph graph = GraphOf(Poses(3, Laps(0.1).front()));
  const OdometrySegment segment = OdometryChain(Options(), graph, 3).Between(0, 2);
  EXPECT_EQ(segment.drift, Matrix6d::Zero());
  EXPECT_NEAR(segment.covariance(0, 0), 2. * 0.1 * 0.02 * 0.02, 1e-12);
}

// Drives the same way again and again, with random errors.
TEST(OdometryChainTest, CovarianceIsThatOfManyDrives) {
  constexpr int kDrives = 4000;
  const Poses truth = Laps(0.3);
  const Graph graph = GraphOf(truth);
  const int end = static_cast<int>(truth.size()) - 1;
  const OdometrySegment segment = OdometryChain(Options(), graph, 3).Between(0, end);
  EXPECT_LT(Difference(segment.odometry, truth.front().inverse() * truth[end]), 1e-10);
  Matrix6d covariance = Matrix6d::Zero();
  for (int i = 0; i < kDrives; ++i) {
    OdometryErrors errors;
    errors.sigmas_per_sqrt_m = ToTwist(Options().random());
    errors.seed = 100 + i;
    const Twist error = Log(truth[end].inverse() * WithErrors(truth, errors)[end]);
    covariance += error * error.transpose() / kDrives;
  }
  // In the frame where it should be the identity.
  const Matrix6d whitening =
      segment.covariance.llt().matrixL().solve(Matrix6d(Matrix6d::Identity()));
  EXPECT_LT(
      (whitening * covariance * whitening.transpose() - Matrix6d::Identity()).cwiseAbs().maxCoeff(),
      0.1);
}

TEST(OdometryChainTest, DriftIsThatOfADriveWithASystematicError) {
  const Poses truth = Laps(0.15);  // some 50 m
  const Graph graph = GraphOf(truth);
  const int end = static_cast<int>(truth.size()) - 1;
  OdometryErrors errors;
  errors.twist_per_m << 1e-3, -2e-3, 1e-3, 1e-5, -2e-5, 2e-5;
  const OdometrySegment segment = OdometryChain(Options(), graph, 3).Between(0, end);
  const Rigid3d expected = truth.front().inverse() * WithErrors(truth, errors)[end];
  const Rigid3d predicted = segment.odometry * Exp(segment.drift * errors.twist_per_m);
  EXPECT_GT(Difference(segment.odometry, expected), 0.05);
  EXPECT_LT(Difference(predicted, expected), 1e-4);
}

TEST(OdometryChainTest, PosesBetweenAreTheOdometrysIfTheEndsAgreeWithIt) {
  const Poses poses = Laps(0.2);
  const Graph graph = GraphOf(poses);
  const Rigid3d map_from_local = Exp(Twist::Constant(0.3));
  const Poses between = OdometryChain(Options(), graph, 3)
                            .PosesBetween(2, 12, map_from_local * poses[2],
                                          map_from_local * poses[12], Twist::Zero());
  ASSERT_EQ(between.size(), 9);
  for (int i = 3; i < 12; ++i) {
    EXPECT_LT(Difference(between[i - 3], map_from_local * poses[i]), 1e-10);
  }
  EXPECT_TRUE(OdometryChain(Options(), graph, 3)
                  .PosesBetween(2, 3, poses[2], poses[3], Twist::Zero())
                  .empty());
}

double Cost(const OdometryChain& chain, const Poses& poses, const Twist& twist_per_m) {
  double cost = 0.;
  for (int i = 0; i + 1 < static_cast<int>(poses.size()); ++i) {
    const OdometrySegment step = chain.Between(i, i + 1);
    const Twist error = Log((step.odometry * Exp(step.drift * twist_per_m)).inverse() *
                            poses[i].inverse() * poses[i + 1]);
    cost += error.dot(step.covariance.llt().solve(error));
  }
  return cost;
}

// Whatever pose between the ends is moved, whichever way: the steps like it less.
TEST(OdometryChainTest, PosesBetweenAreTheMostLikelyOnes) {
  const Poses truth = Laps(0.1);
  const Graph graph = GraphOf(truth);
  const OdometryChain chain(Options(), graph, 3);
  const int end = chain.size() - 1;
  Twist contradiction, twist_per_m;
  contradiction << 0.05, -0.1, 0.08, 0.01, -0.02, 0.03;
  twist_per_m << 1e-3, 0., 2e-3, 1e-4, 0., 1e-4;
  Poses poses = chain.PosesBetween(0, end, truth[0], truth[end] * Exp(contradiction), twist_per_m);
  poses.insert(poses.begin(), truth[0]);
  poses.push_back(truth[end] * Exp(contradiction));
  const double cost = Cost(chain, poses, twist_per_m);
  for (int i = 1; i < end; ++i) {
    for (int k = 0; k < 6; ++k) {
      // Steps of a fiftieth of the step's standard deviation: the cost's curvature decides, so the
      // minimum is known to that precision.
      const double step = 0.02 * std::sqrt(chain.Between(i, i + 1).covariance(k, k));
      for (const double sign : {-1., 1.}) {
        Poses moved = poses;
        moved[i] = poses[i] * Exp(sign * step * Twist::Unit(k));
        EXPECT_GT(Cost(chain, moved, twist_per_m), cost) << i << " " << k;
      }
    }
  }
}

}  // namespace
}  // namespace cartographer::pose_graph
