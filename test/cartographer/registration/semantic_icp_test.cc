// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/semantic_icp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cartographer/registration/normal_equations.h"
#include "cartographer/transform/se3.h"
#include "tbb/global_control.h"
#include "tbb/task_arena.h"

namespace cartographer::registration {
namespace {

using sensor::kUnlabeled;
using sensor::Label;
using sensor::LabeledPointCloud;
using transform::Exp;
using transform::Rigid3d;
using transform::Twist;

constexpr Label kRoad{1};
constexpr Label kWall{2};

proto::VoxelMapOptions MapOptions() {
  proto::VoxelMapOptions options;
  options.set_voxel_size_m(1.);
  options.set_max_points_per_voxel(20);
  return options;
}

proto::IcpOptions Options() {
  proto::IcpOptions options;
  options.set_max_iterations(500);
  options.set_convergence_threshold(1e-6);
  options.set_min_points(3);
  options.set_min_correspondences(3);
  options.set_weight_by_certainty(true);
  options.set_unlabeled_weight(1.);
  options.set_min_lever_arm_m(0.1);
  options.set_agreeing_distance_factor(1.);
  return options;
}

void AddPoint(const Eigen::Vector3f& position, Label label, float certainty,
              LabeledPointCloud* cloud) {
  cloud->positions.push_back(position);
  cloud->labels.push_back(label);
  cloud->certainties.push_back(certainty);
}

// A street corner: a floor and two walls, sampled at random.
LabeledPointCloud Corner(int seed, int size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.f, 1.f);
  LabeledPointCloud cloud;
  for (int i = 0; i < size; ++i) {
    const float a = 20.f * uniform(random), b = 20.f * uniform(random), c = 4.f * uniform(random);
    if (i % 3 == 0) AddPoint({a, b, 0.f}, kRoad, 0.9f, &cloud);
    if (i % 3 == 1) AddPoint({a, 0.f, c}, kWall, 0.9f, &cloud);
    if (i % 3 == 2) AddPoint({0.f, b, c}, kWall, 0.9f, &cloud);
  }
  return cloud;
}

LabeledVoxelMap MapOf(const LabeledPointCloud& cloud) {
  LabeledVoxelMap map(MapOptions(), {});
  map.Insert(cloud, Rigid3d());
  return map;
}

TEST(SemanticIcpTest, CertaintyWeightsAreThoseOfThePaper) {
  EXPECT_FLOAT_EQ(CertaintyWeight(kRoad, 0.8f, kRoad, 0.3), 0.8);
  EXPECT_FLOAT_EQ(CertaintyWeight(kRoad, 0.8f, kWall, 0.3), 0.2);
  EXPECT_EQ(CertaintyWeight(kUnlabeled, 0.8f, kWall, 0.3), 0.3);
  EXPECT_EQ(CertaintyWeight(kRoad, 0.8f, kUnlabeled, 0.3), 0.3);
  EXPECT_EQ(CertaintyWeight(kUnlabeled, 0.8f, kUnlabeled, 0.3), 0.3);
}

TEST(SemanticIcpTest, FirstStepSolvesTheHandBuiltEquations) {
  // Four pairs within the gate, each with its own weight; one iteration must be the solution of the
  // equations with weights kernel * kappa written out by hand.
  const Eigen::Vector3d targets[] = {{0., 0., 0.}, {5., 0., 0.}, {0., 5., 0.}, {5., 5., 3.}};
  const Label target_labels[] = {kRoad, kWall, kUnlabeled, kRoad};
  LabeledPointCloud map_cloud, source;
  const Eigen::Vector3f shifts[] = {
      {0.1f, 0.f, 0.f}, {0.f, 0.2f, 0.f}, {0.f, 0.f, -0.1f}, {0.05f, 0.05f, 0.f}};
  NormalEquations expected;
  const double sigma = 0.5;
  const double kappas[] = {0.9, 1. - 0.9, 0.7, 0.9};  // agree, disagree, unlabeled target, agree
  for (int i = 0; i < 4; ++i) {
    AddPoint(targets[i].cast<float>(), target_labels[i], 1.f, &map_cloud);
    AddPoint(targets[i].cast<float>() + shifts[i], kRoad, 0.9f, &source);
    const double r2 = shifts[i].cast<double>().squaredNorm();
    const double kernel = std::pow(sigma / (sigma + r2), 2);
    expected.AddPair(source.positions[i].cast<double>(), targets[i], kernel * kappas[i]);
  }
  proto::IcpOptions options = Options();
  options.set_max_iterations(1);
  options.set_unlabeled_weight(0.7);
  const IcpReport report = AlignCloud(source, MapOf(map_cloud), Rigid3d(), {1., sigma}, options);
  EXPECT_EQ(report.outcome, IcpOutcome::kIterationLimit);
  EXPECT_EQ(report.num_correspondences, 4);
  EXPECT_EQ(report.num_agreeing, 2);
  EXPECT_NEAR(report.last_step, expected.Solve().norm(), 1e-6);
  const Rigid3d step = Exp(expected.Solve());
  EXPECT_LT((report.map_from_source.Matrix() - step.Matrix()).norm(), 1e-6);
}

TEST(SemanticIcpTest, RecoversAKnownMotion) {
  const LabeledPointCloud corner = Corner(1, 6000);
  const LabeledVoxelMap map = MapOf(corner);
  // The map keeps a subset of the points, so use it as the source: exact pairs exist.
  const LabeledPointCloud source = map.ToPointCloud();
  Twist offset;
  offset << 0.06, -0.05, 0.04, 0.004, -0.003, 0.006;
  for (const Rigid3d& guess : {Exp(offset), Exp(offset).inverse()}) {
    const IcpReport report = AlignCloud(source, map, guess, {0.5, 0.2}, Options());
    EXPECT_EQ(report.outcome, IcpOutcome::kConverged);
    EXPECT_LT((report.map_from_source.Matrix() - Rigid3d().Matrix()).norm(), 1e-4);
    EXPECT_GT(report.inlier_ratio, 0.99);
  }
}

TEST(SemanticIcpTest, ResultDoesNotDependOnWhereTheMapIs) {
  const LabeledPointCloud corner = Corner(2, 3000);
  Twist offset;
  offset << 0.05, 0.05, -0.05, 0.003, 0.002, -0.004;
  const Rigid3d far = Rigid3d::Translation({8192., -4096., 64.});  // whole voxels
  const LabeledVoxelMap near_map = MapOf(corner);
  LabeledVoxelMap far_map(MapOptions(), {});
  far_map.Insert(corner, far);
  const LabeledPointCloud source = near_map.ToPointCloud();
  const IcpReport near_report = AlignCloud(source, near_map, Exp(offset), {0.5, 0.2}, Options());
  const IcpReport far_report =
      AlignCloud(source, far_map, far * Exp(offset), {0.5, 0.2}, Options());
  EXPECT_EQ(near_report.iterations, far_report.iterations);
  EXPECT_LT((far.inverse() * far_report.map_from_source).Matrix().col(3).norm(), 1e-3);
}

TEST(SemanticIcpTest, LabelsTurnAwayFromTheWrongSurface) {
  // A wall, and an untrue copy of it 0.3 m behind that is labeled otherwise and nearer to the scan.
  // With labels the scan snaps to the wall, without them it stays at the copy.
  LabeledPointCloud map_cloud, source;
  for (int y = 0; y < 40; ++y) {
    for (int z = 0; z < 20; ++z) {
      AddPoint({0.f, 0.25f * y, 0.25f * z}, kWall, 1.f, &map_cloud);
      AddPoint({0.3f, 0.25f * y, 0.25f * z}, kRoad, 1.f, &map_cloud);
      AddPoint({0.2f, 0.25f * y, 0.25f * z}, kWall, 0.99f, &source);
    }
  }
  const LabeledVoxelMap map = MapOf(map_cloud);
  proto::IcpOptions options = Options();
  options.set_weight_by_certainty(false);
  const IcpReport plain = AlignCloud(source, map, Rigid3d(), {1., 1.}, options);
  EXPECT_NEAR(plain.map_from_source.translation().x(), 0.1, 0.02);
  // Half of the scan sees the wall itself: disagreeing pairs weigh 1 % of agreeing ones.
  for (size_t i = 0; i < source.size(); i += 2) source.positions[i].x() = 0.1f;
  const IcpReport semantic = AlignCloud(source, map, Rigid3d(), {1., 1.}, Options());
  const IcpReport deaf = AlignCloud(source, map, Rigid3d(), {1., 1.}, options);
  // Both halves are drawn to the wall: one wants -0.1 m, the other -0.2 m.
  EXPECT_LT(semantic.map_from_source.translation().x(), -0.1);
  EXPECT_GT(semantic.map_from_source.translation().x(), -0.2);
  EXPECT_NEAR(deaf.map_from_source.translation().x(), 0., 0.02);
}

TEST(SemanticIcpTest, OutcomesAreToldApart) {
  const LabeledVoxelMap map = MapOf(Corner(3, 3000));
  const LabeledPointCloud source = map.ToPointCloud();
  const Rigid3d guess = Rigid3d::Translation({0.01, 0., 0.});
  const IcpScale scale{0.5, 0.2};

  LabeledPointCloud two;
  two.Append(source, 0);
  two.Append(source, 1);
  EXPECT_EQ(AlignCloud(two, map, guess, scale, Options()).outcome, IcpOutcome::kTooFewPoints);
  EXPECT_EQ(AlignCloud({}, map, guess, scale, Options()).outcome, IcpOutcome::kTooFewPoints);

  const Rigid3d elsewhere = Rigid3d::Translation({500., 0., 0.});
  const IcpReport lost = AlignCloud(source, map, elsewhere, scale, Options());
  EXPECT_EQ(lost.outcome, IcpOutcome::kNoCorrespondences);
  EXPECT_FALSE(lost.HasEstimate());
  EXPECT_EQ(lost.map_from_source.Matrix(), elsewhere.Matrix());

  LabeledPointCloud line;
  for (int i = 0; i < 100; ++i) AddPoint({0.1f * i, 0.f, 0.f}, kRoad, 1.f, &line);
  EXPECT_EQ(AlignCloud(line, MapOf(line), guess, scale, Options()).outcome,
            IcpOutcome::kDegenerate);

  proto::IcpOptions impatient = Options();
  impatient.set_max_iterations(1);
  const IcpReport limited = AlignCloud(source, map, guess, scale, impatient);
  EXPECT_EQ(limited.outcome, IcpOutcome::kIterationLimit);
  EXPECT_EQ(limited.iterations, 1);
  EXPECT_TRUE(limited.HasEstimate());

  EXPECT_EQ(AlignCloud(source, map, guess, scale, Options()).outcome, IcpOutcome::kConverged);
}

TEST(SemanticIcpTest, PairsWithoutWeightAreNoPairs) {
  LabeledPointCloud roads = Corner(4, 300), walls = roads;
  for (size_t i = 0; i < roads.size(); ++i) {
    roads.labels[i] = kRoad;
    roads.certainties[i] = 1.f;
    walls.labels[i] = kWall;
  }
  // Certain of the label, and it never agrees: kappa is 0 everywhere.
  EXPECT_EQ(AlignCloud(roads, MapOf(walls), Rigid3d(), {0.5, 0.2}, Options()).outcome,
            IcpOutcome::kNoCorrespondences);
}

TEST(SemanticIcpTest, SameBitsOnAnyNumberOfThreads) {
  const LabeledVoxelMap map = MapOf(Corner(5, 20000));
  const LabeledPointCloud source = Corner(6, 3000);
  const Rigid3d guess = Rigid3d::Translation({0.1, -0.1, 0.05});
  const auto align = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(threads);
    return arena.execute([&] { return AlignCloud(source, map, guess, {0.5, 0.2}, Options()); });
  };
  const IcpReport reference = align(1);
  for (const int threads : {2, 8}) {
    const IcpReport report = align(threads);
    EXPECT_EQ(report.map_from_source.Matrix(), reference.map_from_source.Matrix());
    EXPECT_EQ(report.iterations, reference.iterations);
  }
}

}  // namespace
}  // namespace cartographer::registration
