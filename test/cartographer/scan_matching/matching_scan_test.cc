// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/matching_scan.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <tuple>

#include "test/cartographer/scan_matching/small_scenes.h"

namespace cartographer::scan_matching {
namespace {

constexpr int kBuilding = 4, kPole = 6, kMovingCar = 8;

TEST(MatchingScanTest, LeavesOutWhatDoesNotCount) {
  proto::ScoreOptions options = SmallOptions("dominant_label");
  options.set_max_range_m(50.);
  sensor::LabeledPointCloud cloud;
  AddPoint(3., 4., kBuilding, &cloud);
  AddPoint(1., 1., kMovingCar, &cloud);
  AddPoint(40., 40., kBuilding, &cloud);
  AddPoint(std::nan(""), 1., kBuilding, &cloud);
  AddPoint(1., std::numeric_limits<double>::infinity(), kBuilding, &cloud);
  AddPoint(1., 1., kBuilding, &cloud);
  cloud.positions.back().z() = std::nanf("");
  const MatchingScan scan(cloud, SmallModel(options));
  EXPECT_EQ(scan.size(), 1);
  EXPECT_EQ(scan.total_weight(), 64);
  EXPECT_DOUBLE_EQ(scan.radius_m(), 5.);
}

TEST(MatchingScanTest, KeepsAsManyPointsAsAskedSpreadOverTheScan) {
  const ScoreModel model = SmallModel(SmallOptions("dominant_label"));
  sensor::LabeledPointCloud cloud;
  for (int i = 0; i < 100; ++i) AddPoint(0.2 * i, 1., kBuilding, &cloud);
  EXPECT_EQ(MatchingScan(cloud, model, 100).size(), 100u);
  const MatchingScan thinned(cloud, model, 30);
  EXPECT_LE(thinned.size(), 30u);
  EXPECT_GE(thinned.size(), 20u);
  EXPECT_EQ(thinned.total_weight(), static_cast<int64_t>(64 * thinned.size()));
  double last_x = -1.;
  thinned.ForEachPoint([&](int, const Eigen::Vector2d& position, int) {
    EXPECT_LE(position.x() - last_x, 1.5);
    last_x = position.x();
  });
  EXPECT_GT(last_x, 18.);
}

TEST(MatchingScanTest, AnEmptyScanHasNoCells) {
  const MatchingScan scan({}, SmallModel(SmallOptions("dominant_label")));
  EXPECT_TRUE(scan.empty());
  EXPECT_EQ(scan.radius_m(), 0.);
  EXPECT_TRUE(scan.CellsAt({}, 0.2).cells.empty());
}

TEST(MatchingScanTest, PointsOfOneCellAreOneCellWithTheirWeight) {
  const ScoreModel model = SmallModel(SmallOptions("dominant_label"));
  sensor::LabeledPointCloud cloud;
  for (int i = 0; i < 10; ++i) {
    AddPoint(2.31, 1.12, kPole, &cloud);
    AddPoint(2.31, 1.12, kBuilding, &cloud);
  }
  const auto cells = MatchingScan(cloud, model).CellsAt({{10., -5.}, M_PI / 2.}, 0.5);
  ASSERT_EQ(cells.cells.size(), 2);
  ASSERT_EQ(cells.layers.size(), 2);
  for (const auto& [layer, begin, end] : cells.layers) {
    ASSERT_EQ(end, begin + 1);
    const bool is_pole = layer == model.LayerOf(LabelAt(kPole));
    EXPECT_EQ(cells.cells[begin].weight, is_pole ? 10 * 192 : 10 * 64);
    // (2.31, 1.12) turned left is (-1.12, 2.31); then (8.88, -2.69) in cells of half a metre.
    EXPECT_EQ(cells.cells[begin].x, 17);
    EXPECT_EQ(cells.cells[begin].y, -6);
  }
}

TEST(MatchingScanTest, CellsEqualThoseOfEachPointByItselfAndAscendByLayer) {
  std::mt19937 random(3);
  const ScoreModel model = SmallModel(SmallOptions("dominant_label"));
  const RandomScene scene(1, 1, 500, 20., &random);
  const MatchingScan scan(scene.cloud, model);
  const PlanarPose pose{{103.4, -77.7}, 2.5};
  const submap::SemanticGrid grid(0.2);
  std::map<std::tuple<int, int, int>, int> expected, found;
  for (size_t i = 0; i < scene.cloud.size(); ++i) {
    const sensor::Label label = scene.cloud.labels[i];
    if (model.LayerOf(label) == ScoreModel::kNotMatched) continue;
    const Eigen::Vector3d position = InSpace(pose) * scene.cloud.positions[i].cast<double>();
    const int x = static_cast<int>(std::floor(position.x() / 0.2));
    const int y = static_cast<int>(std::floor(position.y() / 0.2));
    expected[{model.LayerOf(label), x, y}] += model.WeightOf(label);
  }
  int last_layer = 0;
  int64_t total = 0;
  const ScanCells cells = scan.CellsAt(pose, 0.2);
  for (const auto& [layer, begin, end] : cells.layers) {
    EXPECT_GE(layer, last_layer);
    last_layer = layer;
    for (size_t i = begin; i < end; ++i) {
      const ScanCell& cell = cells.cells[i];
      total += cell.weight;
      found[{layer, cell.x, cell.y}] += cell.weight;
    }
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(total, scan.total_weight());
}

TEST(MatchingScanTest, WeightsOfACellStayWithinBounds) {
  sensor::LabeledPointCloud cloud;
  for (int i = 0; i < 1000; ++i) AddPoint(0.1, 0.1, kPole, &cloud);
  const MatchingScan scan(cloud, SmallModel(SmallOptions("dominant_label")));
  int64_t total = 0;
  for (const ScanCell& cell : scan.CellsAt({}, 0.5).cells) {
    EXPECT_LE(cell.weight, kMaxCellWeight);
    total += cell.weight;
  }
  EXPECT_EQ(total, 1000 * 192);
}

TEST(MatchingScanTest, HugeScansAreThinned) {
  sensor::LabeledPointCloud cloud;
  for (int i = 0; i < 300000; ++i) AddPoint(1e-4 * i, 0., kBuilding, &cloud);
  const MatchingScan scan(cloud, SmallModel(SmallOptions("dominant_label")));
  EXPECT_EQ(scan.total_weight(), 64 * static_cast<int64_t>(scan.size()));
  EXPECT_LE(scan.total_weight() * 255, std::numeric_limits<int32_t>::max());
  EXPECT_GT(scan.size(), 40000);
}

}  // namespace
}  // namespace cartographer::scan_matching
