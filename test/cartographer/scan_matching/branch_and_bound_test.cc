// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/branch_and_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <tuple>

#include "cartographer/scan_matching/submap_matcher.h"
#include "tbb/global_control.h"
#include "test/cartographer/scan_matching/small_scenes.h"

namespace cartographer::scan_matching {
namespace {

constexpr uint32_t kSeed = 20260401;
constexpr double kResolution_m = 0.5;

int32_t SumAt(const PlainScore& plain, const std::vector<std::tuple<int, int, int, int>>& points,
              int shift_x, int shift_y) {
  int32_t sum = 0;
  for (const auto& [x, y, label, weight] : points) {
    sum += weight * plain.Agreement(label, x + shift_x, y + shift_y);
  }
  return sum;
}

// Scores every pose of the space, one after the other, and keeps the first of the best.
std::optional<BestPose> FindExhaustively(const proto::ScoreOptions& options,
                                         const RandomScene& scene, const SearchSpace& space,
                                         int32_t min_score) {
  const PlainScore plain(options, scene.grid);
  std::optional<BestPose> best;
  for (size_t yaw = 0; yaw < space.yaws_rad.size(); ++yaw) {
    // Each point by itself, so that nothing is merged nor reordered.
    std::vector<std::tuple<int, int, int, int>> points;
    for (size_t i = 0; i < scene.cloud.size(); ++i) {
      const int label = static_cast<int>(sensor::Index(scene.cloud.labels[i]));
      const int weight = PlainScore::Weight(options.score(), label);
      if (weight == 0) continue;
      sensor::LabeledPointCloud point;
      point.Append(scene.cloud, i);
      const auto cells = MatchingScan(point, SmallModel(options))
                             .CellsAt(space.PoseAt(yaw, {0, 0}, kResolution_m), kResolution_m);
      points.emplace_back(cells.cells.at(0).x, cells.cells.at(0).y, label, weight);
    }
    for (int y = 0; y < space.num_shifts.y(); ++y) {
      for (int x = 0; x < space.num_shifts.x(); ++x) {
        const submap::CellIndex shift = space.first_shift + submap::CellIndex(x, y);
        const int32_t score = SumAt(plain, points, shift.x(), shift.y());
        if (score < std::max(1, min_score)) continue;
        if (!best.has_value() || score > best->score) best = BestPose{score, yaw, shift};
      }
    }
  }
  return best;
}

void ExpectSame(const std::optional<BestPose>& found, const std::optional<BestPose>& expected) {
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found.has_value()) return;
  EXPECT_EQ(found->score, expected->score);
  EXPECT_EQ(found->yaw, expected->yaw);
  EXPECT_EQ(found->shift.x(), expected->shift.x());
  EXPECT_EQ(found->shift.y(), expected->shift.y());
}

class BranchAndBoundTest : public ::testing::TestWithParam<const char*> {};

TEST_P(BranchAndBoundTest, EqualsExhaustiveSearchOnAThousandSmallCases) {
  std::cerr << "seed " << kSeed << "\n";
  std::mt19937 random(kSeed);
  const auto draw = [&random](int min, int max) {
    return std::uniform_int_distribution<int>(min, max)(random);
  };
  int num_found = 0;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const auto options = SmallOptions(GetParam(), 0.25 * draw(0, 4), draw(1, 5));
    const ScoreModel model = SmallModel(options);
    const RandomScene scene(draw(1, 24), draw(1, 200), draw(1, 16), 3., &random);
    const MatchingScan scan(scene.cloud, model);
    const PlanarPose guess{{0.31 * draw(-10, 10), 0.17 * draw(-10, 10)}, 0.3 * draw(-10, 10)};
    const SearchSpace space =
        SpaceAround(guess, {0.25 * draw(0, 20), 0.1 * draw(0, 5)}, kResolution_m, scan.radius_m());
    const auto min_score = static_cast<int32_t>(scan.total_weight() * 255 * draw(0, 8) / 16);
    const ScorePyramid pyramid(scene.grid, model);
    const auto found = FindBestPose(pyramid, scan, space, kResolution_m, min_score, nullptr);
    ExpectSame(found, FindExhaustively(options, scene, space, min_score));
    if (HasFailure()) return;
    num_found += found.has_value() ? 1 : 0;
  }
  // Neither nearly all nor nearly none reach the lowest score that is asked for.
  EXPECT_GT(num_found, 300);
  EXPECT_LT(num_found, 950);
}

// Wide enough for every level of the pyramid to have several blocks.
TEST_P(BranchAndBoundTest, EqualsExhaustiveSearchInWideWindows) {
  std::mt19937 random(kSeed + 1);
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const auto options = SmallOptions(GetParam(), 0.5 * (i % 3), 1 + i % 4);
    const ScoreModel model = SmallModel(options);
    const RandomScene scene(300, 6000, 6, 1.2, &random);
    const MatchingScan scan(scene.cloud, model);
    const SearchSpace space =
        i % 2 == 0 ? WholeSpace(scene.grid.Bounds(), kResolution_m, scan.radius_m())
                   : SpaceAround({{3.3, -7.1}, 1.}, {40., 0.4}, kResolution_m, scan.radius_m());
    const ScorePyramid pyramid(scene.grid, model);
    ExpectSame(FindBestPose(pyramid, scan, space, kResolution_m, 0, nullptr),
               FindExhaustively(options, scene, space, 0));
  }
}

TEST_P(BranchAndBoundTest, BoundsAreAtLeastTheScoresOfAllPosesBelow) {
  std::mt19937 random(kSeed + 2);
  std::uniform_int_distribution<int> coordinate(-180, 180);
  for (int i = 0; i < 20; ++i) {
    const auto options = SmallOptions(GetParam(), 0.25 * (i % 5), 1 + i % 4);
    const ScoreModel model = SmallModel(options);
    const RandomScene scene(40 + 10 * i, 1000, 1, 1., &random);
    const ScorePyramid pyramid(scene.grid, model);
    const PlainScore plain(options, scene.grid);
    for (int trial = 0; trial < 300; ++trial) {
      const submap::CellIndex cell(coordinate(random), coordinate(random));
      const submap::CellIndex shift(coordinate(random), coordinate(random));
      for (int label = 0; label < kNumSmallLabels; ++label) {
        const int layer = model.LayerOf(LabelAt(label));
        if (layer == ScoreModel::kNotMatched) continue;
        const int exact = plain.Agreement(label, cell.x() + shift.x(), cell.y() + shift.y());
        EXPECT_EQ(pyramid.level(0).BoundAt(pyramid.PlaneOf(0, layer), cell, shift), exact);
        for (int level = 1; level < pyramid.num_levels(); ++level) {
          const int window = pyramid.level(level).log2_window();
          const submap::CellIndex block(shift.x() >> window, shift.y() >> window);
          EXPECT_GE(pyramid.level(level).BoundAt(pyramid.PlaneOf(level, layer), cell, block), exact)
              << "level " << level;
        }
      }
    }
    if (HasFailure()) return;
  }
}

// A bound that is always 255 would be admissible, too.
TEST_P(BranchAndBoundTest, BoundsLookNoFartherThanTheirWindows) {
  const ScoreModel model = SmallModel(SmallOptions(GetParam()));
  submap::SemanticGrid grid(kResolution_m);
  grid.AddHits(LabelAt(6), {5, 9}, 10);
  const ScorePyramid pyramid(grid, model);
  const int layer = model.LayerOf(LabelAt(6));
  for (int level = 0; level < pyramid.num_levels(); ++level) {
    const int window = 1 << pyramid.level(level).log2_window();
    const int plane = pyramid.PlaneOf(level, layer);
    int num_cells = 0;
    for (int x = -300; x < 300; ++x) {
      num_cells += pyramid.level(level).BoundAt(plane, {x, 9}, {0, 0}) > 0 ? 1 : 0;
    }
    EXPECT_GE(num_cells, window);
    EXPECT_LE(num_cells, window + window / 4);
  }
}

TEST_P(BranchAndBoundTest, IsTheSameOnOneTwoAndEightThreads) {
  std::mt19937 random(kSeed + 3);
  for (int i = 0; i < 20; ++i) {
    const ScoreModel model = SmallModel(SmallOptions(GetParam(), 0.5, 1));
    const RandomScene scene(60, 1500, 12, 6., &random);
    const MatchingScan scan(scene.cloud, model);
    const ScorePyramid pyramid(scene.grid, model);
    const SearchSpace space = WholeSpace(scene.grid.Bounds(), kResolution_m, scan.radius_m());
    std::optional<BestPose> on_one;
    for (const int num_threads : {1, 2, 8}) {
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, num_threads);
      const auto found = FindBestPose(pyramid, scan, space, kResolution_m, 0, nullptr);
      if (num_threads == 1) on_one = found;
      ExpectSame(found, on_one);
    }
  }
}

TEST_P(BranchAndBoundTest, ASharedBoundNeverChangesTheWinner) {
  std::mt19937 random(kSeed + 4);
  int num_cut_short = 0;
  for (int i = 0; i < 20; ++i) {
    const ScoreModel model = SmallModel(SmallOptions(GetParam(), 0., 1 + i % 2));
    const RandomScene scan_scene(1, 1, 5, 1.5, &random);
    const MatchingScan scan(scan_scene.cloud, model);
    std::vector<std::shared_ptr<const SubmapMatcher>> matchers;
    std::vector<SearchArea> areas;
    for (int submap = 0; submap < 6; ++submap) {
      const RandomScene scene(20, 50 + 50 * (submap % 4), 1, 1., &random);
      matchers.push_back(std::make_shared<const SubmapMatcher>(scene.grid, model));
      areas.push_back({matchers.back(), std::nullopt});
    }
    size_t best = 0;
    std::vector<std::optional<Match>> alone;
    for (const auto& matcher : matchers) alone.push_back(matcher->MatchInWholeSubmap(scan, 0.));
    for (size_t j = 0; j < alone.size(); ++j) {
      const double score = alone[j].has_value() ? alone[j]->score : 0.;
      if (alone[best].has_value() && score > alone[best]->score) best = j;
    }
    if (!alone[best].has_value()) continue;
    for (const int num_threads : {1, 2, 8}) {
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, num_threads);
      const auto together = MatchInAny(areas, scan, 0.);
      ASSERT_TRUE(together.has_value());
      EXPECT_EQ(together->index, best);
      EXPECT_EQ(together->match.score, alone[best]->score);
      EXPECT_EQ(together->match.submap_from_node.translation,
                alone[best]->submap_from_node.translation);
      EXPECT_EQ(together->match.submap_from_node.yaw_rad, alone[best]->submap_from_node.yaw_rad);
    }
    // A bound that is out of reach leaves nothing, one that is just in reach leaves the match.
    SharedScore shared;
    const double full = static_cast<double>(scan.total_weight()) * 255.;
    const auto score = static_cast<int32_t>(std::lround(alone[best]->score * full));
    shared.Raise(score);
    EXPECT_TRUE(matchers[best]->MatchInWholeSubmap(scan, 0., &shared).has_value());
    shared.Raise(score + 1);
    const auto none = matchers[best]->MatchInWholeSubmap(scan, 0., &shared);
    num_cut_short += none.has_value() ? 0 : 1;
  }
  EXPECT_GT(num_cut_short, 10);
}

TEST_P(BranchAndBoundTest, NothingIsFoundInEmptyGridsOrWithEmptyScans) {
  const ScoreModel model = SmallModel(SmallOptions(GetParam()));
  std::mt19937 random(kSeed + 5);
  const RandomScene scene(20, 100, 10, 3., &random);
  const SubmapMatcher in_nothing(submap::SemanticGrid(kResolution_m), model);
  const SubmapMatcher matcher(scene.grid, model);
  const MatchingScan scan(scene.cloud, model), no_scan({}, model);
  for (const double min_score : {0., 0.5, 1., 2.}) {
    EXPECT_FALSE(in_nothing.MatchInWholeSubmap(scan, min_score).has_value());
    EXPECT_FALSE(in_nothing.MatchInWindow(scan, {}, {5., 1.}, min_score).has_value());
    EXPECT_FALSE(matcher.MatchInWholeSubmap(no_scan, min_score).has_value());
    EXPECT_FALSE(matcher.MatchInWindow(no_scan, {}, {5., 1.}, min_score).has_value());
  }
  EXPECT_EQ(matcher.ScoreAt(no_scan, {}), 0.);
  EXPECT_EQ(in_nothing.ScoreAt(scan, {}), 0.);
  EXPECT_FALSE(matcher.MatchInWholeSubmap(scan, 2.).has_value());
  // So far away that nothing is in reach.
  EXPECT_FALSE(matcher.MatchInWindow(scan, {{5000., -70000.}, 1.}, {5., 1.}, 0.).has_value());
}

INSTANTIATE_TEST_SUITE_P(Scores, BranchAndBoundTest,
                         ::testing::Values("dominant_label", "max_layer", "occupancy"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace cartographer::scan_matching
