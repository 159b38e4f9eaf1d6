// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_SCAN_MATCHING_CROSSING_SCENE_H_
#define TEST_CARTOGRAPHER_SCAN_MATCHING_CROSSING_SCENE_H_

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "cartographer/scan_matching/submap_matcher.h"
#include "test/cartographer/scan_matching/small_scenes.h"

namespace cartographer::scan_matching {

struct WorldPoint {
  Eigen::Vector2d position;
  int label;
};

inline constexpr double kCrossingResolution_m = 0.2;

// A crossing with houses of different lengths, hedges, poles and parked cars, 60 m across.
inline std::vector<WorldPoint> Crossing(std::mt19937* random) {
  std::vector<WorldPoint> points;
  const auto line = [&](double x0, double y0, double x1, double y1, int label, int hits) {
    const Eigen::Vector2d from(x0, y0), to(x1, y1);
    const int count = static_cast<int>((to - from).norm() / 0.05);
    std::normal_distribution<double> noise(0., 0.02);
    for (int i = 0; i < count * hits; ++i) {
      const double along = static_cast<double>(i % count) / count;
      points.push_back(
          {from + along * (to - from) + Eigen::Vector2d(noise(*random), noise(*random)), label});
    }
  };
  line(-30., 8., -9., 8., 4, 3);
  line(-9., 8., -9., 26., 4, 3);
  line(7., 9., 22., 9., 4, 3);
  line(7., 9., 7., 17., 4, 3);
  line(-28., -8., -12., -8., 5, 3);
  line(9., -10., 30., -7., 5, 3);
  line(12., -24., 12., -14., 4, 3);
  for (const double x : {-25., -16., -7., 5., 19., 27.}) line(x, 6.5, x + 0.1, 6.5, 6, 10);
  for (const double x : {-20., -11., 13.}) {
    line(x, -5., x + 4., -5., 1, 2);
    line(x, -5., x, -3.3, 1, 2);
  }
  std::uniform_real_distribution<double> anywhere(-30., 30.);
  for (int i = 0; i < 4000; ++i) {
    const double y = anywhere(*random);
    points.push_back({{anywhere(*random), y}, std::abs(y) < 5. ? 2 : 3});
  }
  return points;
}

inline submap::SemanticGrid GridOf(const std::vector<WorldPoint>& points) {
  submap::SemanticGrid grid(kCrossingResolution_m);
  for (const WorldPoint& point : points) {
    grid.AddHits(LabelAt(point.label), grid.CellOf(point.position.cast<float>()));
  }
  return grid;
}

// What is seen from a pose: every 9th point within 25 m.
inline sensor::LabeledPointCloud ScanFrom(const std::vector<WorldPoint>& points,
                                          const PlanarPose& pose) {
  sensor::LabeledPointCloud cloud;
  const transform::Rigid3d node_from_world = InSpace(pose).inverse();
  for (size_t i = 0; i < points.size(); i += 9) {
    const Eigen::Vector2d& position = points[i].position;
    const Eigen::Vector3d seen = node_from_world * Eigen::Vector3d(position.x(), position.y(), 0.);
    if (seen.norm() < 25.) AddPoint(seen.x(), seen.y(), points[i].label, &cloud);
  }
  return cloud;
}

// The crossing, seen twice with different noise, and a matcher for a score.
class CrossingTest : public ::testing::TestWithParam<const char*> {
 protected:
  explicit CrossingTest(int seed)
      : random_(seed),
        map_points_(Crossing(&random_)),
        seen_points_(Crossing(&random_)),
        model_(SmallModel(SmallOptions(GetParam()))),
        matcher_(GridOf(map_points_), model_) {}

  std::mt19937 random_;
  const std::vector<WorldPoint> map_points_, seen_points_;
  const ScoreModel model_;
  const SubmapMatcher matcher_;
};

// Where nodes may be: in all directions, next to where angles wrap around.
inline const PlanarPose kPosesOnCrossing[] = {
    {{0.3, -0.7}, 0.2},          {{-11.13, 1.37}, 0.},      {{8.21, -2.5}, M_PI},
    {{-4.4, 2.2}, -M_PI + 1e-3}, {{3.3, 0.1}, M_PI - 1e-3}, {{-8., -1.}, M_PI / 2.},
    {{5.55, 5.55}, -M_PI / 2.},  {{10., 0.}, 2.5}};

}  // namespace cartographer::scan_matching

#endif  // TEST_CARTOGRAPHER_SCAN_MATCHING_CROSSING_SCENE_H_
