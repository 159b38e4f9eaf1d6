// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glog/logging.h"
#include "test/testing/small_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::StreetLabels;
using ::testing::ElementsAre;
using ::testing::Pointee;

constexpr sensor::Label kRoad{1}, kCar{2};

std::shared_ptr<sensor::LabeledPointCloud> Cloud(
    const std::vector<std::pair<Eigen::Vector3f, sensor::Label>>& points) {
  auto cloud = std::make_shared<sensor::LabeledPointCloud>();
  for (const auto& [position, label] : points) {
    cloud->positions.push_back(position);
    cloud->labels.push_back(label);
    cloud->certainties.push_back(0.5f);
    cloud->intensities.push_back(0.1f * cloud->size());
  }
  return cloud;
}

// Two submaps with cells of 1 m at (0, 0) and (10, 0) of the map; the node lies in both.
Map TwoSubmaps() {
  Map map;
  map.labels = StreetLabels();
  for (int i = 0; i < 2; ++i) {
    auto submap = std::make_shared<submap::Submap>(1.);
    submap->grid.AddHits(kCar, {5 - 10 * i, 0});
    submap->cloud =
        *Cloud({{{5.5f - 10 * i, 0.5f, 1.f}, kCar}, {{5.5f - 10 * i, 0.5f, 0.f}, kRoad}});
    map.submaps[{0, i}] = {transform::Rigid3d::Translation({10. * i, 0., 0.}), submap};
    map.constraints.push_back({{0, i},
                               {0, 0},
                               transform::Rigid3d::Translation({1. - 10. * i, 0., 0.}),
                               1.,
                               1.,
                               Constraint::Kind::kIntraSubmap});
  }
  MapNode& node = map.nodes[{0, 0}];
  node.map_from_node = transform::Rigid3d::Translation({1., 0., 0.});
  node.cloud = Cloud({{{4.5f, 0.5f, 1.f}, kCar}, {{4.5f, 0.5f, 0.f}, kRoad}});
  return map;
}

// Takes the car's cell away from a submap's grid.
void Lose(int index, Map* map, LostCells* lost) {
  auto submap = std::make_shared<submap::Submap>(*map->submaps.at({0, index}).submap);
  const submap::CellIndex cell(5 - 10 * index, 0);
  ASSERT_EQ(submap->grid.Hits(kCar, cell), 1);
  submap->grid = submap::SemanticGrid(1.);
  map->submaps[{0, index}].submap = submap;
  lost->emplace(submap::SubmapId{0, index}, submap::SemanticGrid(1.))
      .first->second.AddHits(kCar, cell);
}

std::vector<sensor::Label> LabelsOfSubmap(const Map& map, int index) {
  return map.submaps.at({0, index}).submap->cloud.labels;
}

std::vector<sensor::Label> LabelsOfNode(const Map& map) {
  return map.nodes.at({0, 0}).cloud->labels;
}

TEST(RemovePointsTest, LabeledPointsGoFromAllClouds) {
  Map map = TwoSubmaps();
  sensor::LabelMask cars;
  cars.Insert(kCar);
  RemoveLabeledPoints(*FilterScope::Create({}, map), cars, &map);
  EXPECT_THAT(LabelsOfSubmap(map, 0), ElementsAre(kRoad));
  EXPECT_THAT(LabelsOfSubmap(map, 1), ElementsAre(kRoad));
  EXPECT_THAT(LabelsOfNode(map), ElementsAre(kRoad));
  map.nodes.at({0, 0}).cloud->CheckConsistent();
  EXPECT_EQ(map.nodes.at({0, 0}).cloud->intensities.size(), 1u);
  EXPECT_FLOAT_EQ(map.nodes.at({0, 0}).cloud->intensities[0], 0.2f);
}

TEST(RemovePointsTest, PointsAreInTheRegionByTheirOwnPlace) {
  proto::FilterOptions options;
  for (const double number : {5.4, 0.4, 5.6, 0.6}) options.add_box(number);
  Map map = TwoSubmaps();
  sensor::LabelMask cars;
  cars.Insert(kCar);
  RemoveLabeledPoints(*FilterScope::Create(options, map), cars, &map);
  EXPECT_THAT(LabelsOfSubmap(map, 0), ElementsAre(kRoad));
  EXPECT_THAT(LabelsOfSubmap(map, 1), ElementsAre(kRoad));
  EXPECT_THAT(LabelsOfNode(map), ElementsAre(kRoad));

  options.set_box(2, 5.49);
  map = TwoSubmaps();
  RemoveLabeledPoints(*FilterScope::Create(options, map), cars, &map);
  EXPECT_THAT(LabelsOfSubmap(map, 0), ElementsAre(kCar, kRoad));
  EXPECT_THAT(LabelsOfNode(map), ElementsAre(kCar, kRoad));
}

TEST(RemovePointsTest, CloudsThatLoseNothingStayTheSameObjects) {
  Map map = TwoSubmaps();
  const Map before = map;
  sensor::LabelMask poles;
  poles.Insert(sensor::Label{4});
  RemoveLabeledPoints(*FilterScope::Create({}, map), poles, &map);
  RemovePointsOfLostCells({}, &map);
  EXPECT_EQ(map.nodes.at({0, 0}).cloud, before.nodes.at({0, 0}).cloud);
  EXPECT_EQ(map.submaps.at({0, 0}).submap, before.submaps.at({0, 0}).submap);
}

TEST(RemovePointsTest, ASubmapsPointGoesWithItsCell) {
  Map map = TwoSubmaps();
  LostCells lost;
  Lose(1, &map, &lost);
  RemovePointsOfLostCells(lost, &map);
  EXPECT_THAT(LabelsOfSubmap(map, 0), ElementsAre(kCar, kRoad));
  EXPECT_THAT(LabelsOfSubmap(map, 1), ElementsAre(kRoad));
}

TEST(RemovePointsTest, ANodesPointGoesWithTheLastOfItsCells) {
  Map map = TwoSubmaps();
  LostCells lost;
  Lose(1, &map, &lost);
  RemovePointsOfLostCells(lost, &map);
  EXPECT_THAT(LabelsOfNode(map), ElementsAre(kCar, kRoad)) << "submap 0 still has it";
  LostCells lost_later;
  Lose(0, &map, &lost_later);
  RemovePointsOfLostCells(lost_later, &map);
  EXPECT_THAT(LabelsOfNode(map), ElementsAre(kRoad));
}

// Where closures say a node is does not matter: it was put into the submaps where constraints say.
TEST(RemovePointsTest, LoopClosuresDoNotCount) {
  Map map = TwoSubmaps();
  map.constraints[0].kind = Constraint::Kind::kInterSubmap;
  LostCells lost;
  Lose(1, &map, &lost);
  RemovePointsOfLostCells(lost, &map);
  EXPECT_THAT(LabelsOfNode(map), ElementsAre(kRoad));
}

TEST(RemovePointsTest, RoundingDoesNotSaveAPoint) {
  Map map = TwoSubmaps();
  auto submap = std::make_shared<submap::Submap>(*map.submaps.at({0, 0}).submap);
  submap->cloud = *Cloud({{{4.9995f, 0.5f, 1.f}, kCar}, {{4.9f, 0.5f, 1.f}, kCar}});
  map.submaps[{0, 0}].submap = submap;
  LostCells lost;
  Lose(0, &map, &lost);
  RemovePointsOfLostCells(lost, &map);
  ASSERT_EQ(map.submaps.at({0, 0}).submap->cloud.size(), 1u);
  EXPECT_FLOAT_EQ(map.submaps.at({0, 0}).submap->cloud.positions[0].x(), 4.9f);
}

}  // namespace
}  // namespace cartographer::map
