// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/correlative_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test/cartographer/scan_matching/room_scene.h"

namespace cartographer::scan_matching {
namespace {

proto::CorrelativeSearchOptions Options(double window_m, double window_deg) {
  proto::CorrelativeSearchOptions options;
  options.set_enabled(true);
  options.set_window_m(window_m);
  options.set_window_deg(window_deg);
  options.set_max_points(100000);
  return options;
}

double Score(const submap::ProbabilityGrid& grid, const PlanarPoints& points,
             const PlanarPose& pose) {
  double sum = 0.;
  for (const Eigen::Vector2d& point : points) {
    sum +=
        grid.Probability(grid.CellOf(Eigen::Rotation2Dd(pose.yaw_rad) * point + pose.translation));
  }
  return sum / points.size();
}

TEST(CorrelativeSearchTest, ComesWithinACellOfTheTruthFromAfar) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const PlanarPose truth{{1.52, 0.77}, 0.4};
  const PlanarPose guess{{0.8, 1.5}, 0.43};
  const PlanarPose found = SearchAround(grid, SeenFrom(truth, RoomWalls()), guess, Options(1., 3.));
  EXPECT_LT((found.translation - truth.translation).norm(), 0.12);
  EXPECT_LT(std::abs(found.yaw_rad - truth.yaw_rad), 0.01);
}

TEST(CorrelativeSearchTest, NoPoseOfTheLatticeIsBetter) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const PlanarPoints points = SeenFrom({{0.31, -0.22}, 0.02}, RoomWalls());
  const PlanarPose guess{{0., 0.}, 0.};
  const PlanarPose found = SearchAround(grid, points, guess, Options(0.4, 1.5));
  const double score = Score(grid, points, found);
  EXPECT_GT(score, Score(grid, points, guess));
  double farthest = 0.;
  for (const Eigen::Vector2d& point : points) farthest = std::max(farthest, point.norm());
  const double step_rad = 2. * std::asin(0.1 / (2. * farthest));
  const int turns = static_cast<int>(std::ceil(1.5 * M_PI / 180. / step_rad));
  for (int turn = -turns; turn <= turns; ++turn) {
    for (int y = -4; y <= 4; ++y) {
      for (int x = -4; x <= 4; ++x) {
        EXPECT_LE(Score(grid, points, {{0.1 * x, 0.1 * y}, turn * step_rad}), score + 0.005);
      }
    }
  }
}

TEST(CorrelativeSearchTest, PenaltiesKeepTheGuess) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  proto::CorrelativeSearchOptions options = Options(0.5, 1.);
  options.set_translation_penalty_per_m(100.);
  options.set_rotation_penalty_per_deg(100.);
  const PlanarPose guess{{0.3, 0.2}, 0.1};
  const PlanarPose found = SearchAround(grid, SeenFrom({}, RoomWalls()), guess, options);
  EXPECT_LT((found.translation - guess.translation).norm(), 1e-9);
  EXPECT_NEAR(found.yaw_rad, guess.yaw_rad, 1e-9);
}

TEST(CorrelativeSearchTest, ScoresNoMorePointsThanAsked) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const PlanarPoints points = SeenFrom({{0.31, -0.22}, 0.02}, RoomWalls());
  proto::CorrelativeSearchOptions options = Options(0.4, 1.5);
  // Two in three are somewhere else, and only they.
  PlanarPoints mixed = points;
  for (size_t i = 0; i < mixed.size(); ++i) {
    if (i % 3 != 0) mixed[i] = Eigen::Rotation2Dd(0.5) * mixed[i];
  }
  PlanarPoints third;
  for (size_t i = 0; i < mixed.size(); i += 3) third.push_back(mixed[i]);
  options.set_max_points(static_cast<int>(third.size()));
  const PlanarPose found = SearchAround(grid, mixed, PlanarPose{}, options);
  const PlanarPose of_third = SearchAround(grid, third, PlanarPose{}, options);
  EXPECT_EQ(found.translation, of_third.translation);
  EXPECT_EQ(found.yaw_rad, of_third.yaw_rad);
  EXPECT_LT((found.translation - Eigen::Vector2d(0.31, -0.22)).norm(), 0.15);
}

TEST(CorrelativeSearchTest, WithoutPointsOrWindowItIsTheGuess) {
  const submap::ProbabilityGrid grid = GridOf(RoomWalls());
  const PlanarPose guess{{0.3, 0.2}, 0.1};
  EXPECT_EQ(SearchAround(grid, {}, guess, Options(1., 1.)).translation, guess.translation);
  const PlanarPose found = SearchAround(grid, SeenFrom({}, RoomWalls()), guess, Options(0., 0.));
  EXPECT_LT((found.translation - guess.translation).norm(), 1e-9);
  EXPECT_NEAR(found.yaw_rad, guess.yaw_rad, 1e-9);
}

}  // namespace
}  // namespace cartographer::scan_matching
