// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/io/semantic_raster.h"
#include "glog/logging.h"
#include "tbb/global_control.h"
#include "tbb/task_arena.h"
#include "test/testing/map_sketch.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::StreetLabels;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WholeFrame;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr sensor::Label kRoad{1}, kCar{2}, kBuilding{3}, kPole{4};

FilteredMap Filtered(const Map& map, const proto::FilterOptions& options) {
  auto filtered = Filter(map, options);
  CHECK(filtered.ok()) << filtered.status();
  return *std::move(filtered);
}

// The map's file, apart from its history: all that filters may change. Proves that it can be
// written and read.
std::string BytesOf(Map map) {
  map.history.clear();
  const TemporaryDirectory directory;
  const absl::Status status = io::WriteMap(map, directory / "map");
  CHECK(status.ok()) << status;
  CHECK(io::ReadMap(directory / "map").ok());
  return ReadText(directory / "map");
}

proto::FilterOptions Remove(const std::vector<std::string>& names) {
  proto::FilterOptions options;
  for (const std::string& name : names) options.add_remove(name);
  return options;
}

void SetBox(const std::vector<double>& numbers, proto::FilterOptions* options) {
  for (const double number : numbers) options->add_box(number);
}

void SetTransient(proto::FilterOptions* options) {
  options->set_remove_transient(true);
  options->mutable_transient()->set_tolerance_m(0.5);
  options->mutable_transient()->set_min_ground_hits(1);
  options->mutable_transient()->set_max_movable_share(0.5);
  options->mutable_transient()->set_max_height_difference_m(1000.);
}

// A small map whose nodes lie in its submaps, so that points follow cells, and whose submaps
// overlap.
Map ConnectedMap() {
  Map map = SmallMap(6, 120, 15.f);
  double x = 0.;
  for (auto& [id, placed] : map.submaps) {
    placed.map_from_submap = transform::Rigid3d::Translation({x += 2., 0., 0.});
  }
  std::map<submap::SubmapId, sensor::LabeledPointCloud> clouds;
  for (Constraint& constraint : map.constraints) {
    constraint.submap_from_node = transform::Rigid3d();
    const auto& node = map.nodes.at(constraint.node_id);
    auto submap = std::make_shared<submap::Submap>(*map.submaps.at(constraint.submap_id).submap);
    submap->grid.AddCloud(*node.cloud, transform::Rigid3d(), {});
    map.submaps.at(constraint.submap_id).submap = submap;
  }
  return map;
}

TEST(FilterTest, RemovesALabelFromGridsAndClouds) {
  const Map before = ConnectedMap();
  const FilteredMap after = Filtered(before, Remove({"car"}));
  const LabelCounts counts_before = CountMap(before), counts = CountMap(after.map);
  for (size_t i = 0; i < counts.size(); ++i) {
    const bool is_car = i == sensor::Index(kCar);
    EXPECT_EQ(counts[i].hits, is_car ? 0 : counts_before[i].hits);
    EXPECT_EQ(counts[i].submap_points, is_car ? 0 : counts_before[i].submap_points);
    EXPECT_EQ(counts[i].node_points, is_car ? 0 : counts_before[i].node_points);
    EXPECT_EQ(after.report.labels[i].hits, is_car ? counts_before[i].hits : 0);
    EXPECT_EQ(after.report.labels[i].node_points, is_car ? counts_before[i].node_points : 0);
  }
  EXPECT_EQ(after.map.constraints.size(), before.constraints.size());
  EXPECT_EQ(after.map.nodes.size(), before.nodes.size());
}

TEST(FilterTest, OtherLayersAndPointsStayBitByBit) {
  const Map before = ConnectedMap();
  const Map after = Filtered(before, Remove({"car", "pole"})).map;
  for (const auto& [id, placed] : before.submaps) {
    const submap::Submap& left = *after.submaps.at(id).submap;
    for (const sensor::Label label : {sensor::kUnlabeled, kRoad, kBuilding}) {
      const auto layer = placed.submap->grid.LayerOf(label);
      const auto layer_left = left.grid.LayerOf(label);
      ASSERT_EQ(layer_left.size(), layer.size());
      for (const auto& [index, tile] : layer) EXPECT_EQ(layer_left.at(index)->hits, tile->hits);
    }
    size_t next = 0;
    const sensor::LabeledPointCloud& cloud = placed.submap->cloud;
    for (size_t i = 0; i < cloud.size(); ++i) {
      if (cloud.labels[i] == kCar || cloud.labels[i] == kPole) continue;
      ASSERT_LT(next, left.cloud.size());
      EXPECT_EQ(left.cloud.positions[next], cloud.positions[i]);
      EXPECT_EQ(left.cloud.labels[next], cloud.labels[i]);
      EXPECT_EQ(left.cloud.certainties[next++], cloud.certainties[i]);
    }
    EXPECT_EQ(next, left.cloud.size());
  }
}

// As a picture: pixels change only where the label was hit, and to what lies beneath.
TEST(FilterTest, PicturesChangeOnlyWhereTheLabelWas) {
  const Map before = ConnectedMap();
  const Map after = Filtered(before, Remove({"car"})).map;
  const io::RasterFrame frame = WholeFrame(before, 0.125);
  sensor::LabelMask cars, others;
  cars.Insert(kCar);
  for (const sensor::Label label : {sensor::kUnlabeled, kRoad, kBuilding, kPole})
    others.Insert(label);
  const io::SemanticRaster whole = io::ComposeRaster(before, {}, frame);
  const io::SemanticRaster hidden = io::ComposeRaster(before, cars, frame);
  const io::SemanticRaster cars_alone = io::ComposeRaster(before, others, frame);
  const io::SemanticRaster filtered = io::ComposeRaster(after, {}, frame);
  EXPECT_EQ(filtered.labels, hidden.labels);
  EXPECT_EQ(filtered.hits, hidden.hits);
  int num_uncovered = 0;
  for (size_t i = 0; i < frame.size(); ++i) {
    if (cars_alone.hits[i] > 0.f) {
      num_uncovered += whole.labels[i] == kCar && filtered.hits[i] > 0.f;
    } else {
      EXPECT_EQ(filtered.labels[i], whole.labels[i]);
      EXPECT_EQ(filtered.hits[i], whole.hits[i]);
    }
  }
  EXPECT_GT(num_uncovered, 0);
}

// Each of these removes something of ConnectedMap().
std::vector<proto::FilterOptions> SomeFilters() {
  std::vector<proto::FilterOptions> all;
  all.push_back(Remove({"car"}));
  all.push_back(Remove({"building", "pole"}));
  all.emplace_back().add_keep_roles("ground");
  SetBox({-5., -5., 3., 2.}, &all.emplace_back());
  all.push_back(Remove({"car"}));
  SetBox({-5., -5., 3., 2.}, &all.back());
  all.back().set_outside(true);
  all.emplace_back().set_min_hits(4);
  all.emplace_back().add_trajectories(4);
  SetTransient(&all.emplace_back());
  all.push_back(Remove({"pole"}));
  all.back().add_keep_trajectories(4);
  all.back().set_min_hits(7);
  return all;
}

TEST(FilterTest, TwiceIsOnce) {
  for (const proto::FilterOptions& options : SomeFilters()) {
    SCOPED_TRACE(options.ShortDebugString());
    const FilteredMap once = Filtered(ConnectedMap(), options);
    EXPECT_FALSE(once.report.IsEmpty());
    if (!once.map.nodes.empty() && options.trajectories().empty()) {
      const FilteredMap twice = Filtered(once.map, options);
      EXPECT_TRUE(twice.report.IsEmpty());
      EXPECT_EQ(twice.map.history, once.map.history);
      EXPECT_EQ(BytesOf(twice.map), BytesOf(once.map));
    }
  }
}

// What removes labels may come one after the other, in any order, or at once.
TEST(FilterTest, OneAfterTheOtherIsBothAtOnce) {
  const Map map = ConnectedMap();
  const std::string both = BytesOf(Filtered(map, Remove({"car", "pole"})).map);
  EXPECT_EQ(BytesOf(Filtered(Filtered(map, Remove({"car"})).map, Remove({"pole"})).map), both);
  EXPECT_EQ(BytesOf(Filtered(Filtered(map, Remove({"pole"})).map, Remove({"car"})).map), both);
}

// Where different rules meet, it is in the order in which one filter applies them.
TEST(FilterTest, RulesComeOneAfterTheOther) {
  const Map map = ConnectedMap();
  proto::FilterOptions labels = Remove({"pole"}), hits, visits;
  hits.set_min_hits(4);
  SetTransient(&visits);
  for (const bool confined : {false, true}) {
    proto::FilterOptions all = labels;
    all.MergeFrom(hits);
    all.MergeFrom(visits);
    Map step = map;
    for (proto::FilterOptions rule : {labels, hits, visits}) {
      if (confined) SetBox({-6., -6., 4., 4.}, &rule);
      step = Filtered(step, rule).map;
    }
    if (confined) SetBox({-6., -6., 4., 4.}, &all);
    EXPECT_EQ(BytesOf(step), BytesOf(Filtered(map, all).map));
  }
}

TEST(FilterTest, BoxAndOutsideTogetherAreTheWhole) {
  proto::FilterOptions options = Remove({"car"});
  SetBox({-5., -5., 3., 2.}, &options);
  const Map inside = Filtered(ConnectedMap(), options).map;
  EXPECT_GT(CountMap(inside)[sensor::Index(kCar)].node_points, 0u);
  options.set_outside(true);
  EXPECT_EQ(BytesOf(Filtered(inside, options).map),
            BytesOf(Filtered(ConnectedMap(), Remove({"car"})).map));
}

TEST(FilterTest, ARegionAloneLosesEverything) {
  proto::FilterOptions options;
  SetBox({-1000., -1000., 1000., 1000.}, &options);
  const FilteredMap empty = Filtered(ConnectedMap(), options);
  for (const LabelCount& count : CountMap(empty.map)) EXPECT_TRUE(count.IsZero());
  EXPECT_EQ(empty.map.submaps.size(), ConnectedMap().submaps.size()) << "but not the submaps";
  BytesOf(empty.map);
}

TEST(FilterTest, ATrajectoryAloneGoesAsAWhole) {
  proto::FilterOptions options;
  options.add_trajectories(1);
  const FilteredMap after = Filtered(ConnectedMap(), options);
  EXPECT_EQ(after.report.trajectories.nodes, 6);
  EXPECT_EQ(after.report.trajectories.submaps, 3);
  EXPECT_EQ(after.report.trajectories.constraints, 7);
  EXPECT_GT(after.report.labels[sensor::Index(kRoad)].hits, 0u);
  EXPECT_EQ(after.map.nodes.begin()->first.trajectory_id, 4);
  EXPECT_THAT(after.map.history.back(), HasSubstr("removed 6 nodes, 3 submaps, 7 constraints"));
  BytesOf(after.map);
  proto::FilterOptions keep;
  keep.add_keep_trajectories(4);
  EXPECT_EQ(BytesOf(Filtered(ConnectedMap(), keep).map), BytesOf(after.map));
}

TEST(FilterTest, ATrajectoryConfinesOtherRules) {
  proto::FilterOptions options = Remove({"car"});
  options.add_trajectories(1);
  const Map after = Filtered(ConnectedMap(), options).map;
  for (const auto& [id, node] : after.nodes) {
    const auto& labels = node.cloud->labels;
    const bool has_cars = std::find(labels.begin(), labels.end(), kCar) != labels.end();
    EXPECT_EQ(has_cars, id.trajectory_id == 4);
  }
}

TEST(FilterTest, RareCellsGoWithTheirPoints) {
  Map map;
  map.labels = StreetLabels();
  auto submap = std::make_shared<submap::Submap>(1.);
  submap->grid.AddHits(kCar, {0, 0}, 2);
  submap->grid.AddHits(kRoad, {0, 0}, 3);
  submap->grid.AddHits(kCar, {1, 0}, 3);
  for (const float x : {0.5f, 1.5f}) {
    submap->cloud.positions.emplace_back(x, 0.5f, 0.f);
    submap->cloud.labels.push_back(kCar);
    submap->cloud.certainties.push_back(1.f);
  }
  map.submaps[{0, 0}].submap = submap;
  proto::FilterOptions options;
  options.set_min_hits(3);
  const FilteredMap after = Filtered(map, options);
  const submap::Submap& left = *after.map.submaps.at({0, 0}).submap;
  EXPECT_EQ(left.grid.Hits(kCar, {0, 0}), 0);
  EXPECT_EQ(left.grid.Hits(kRoad, {0, 0}), 3);
  EXPECT_EQ(left.grid.Hits(kCar, {1, 0}), 3);
  ASSERT_EQ(left.cloud.size(), 1u);
  EXPECT_EQ(left.cloud.positions[0].x(), 1.5f);
}

TEST(FilterTest, HistoryGrowsByALineIfSomethingGoes) {
  const Map before = ConnectedMap();
  const FilteredMap after = Filtered(before, Remove({"car"}));
  ASSERT_EQ(after.map.history.size(), before.history.size() + 1);
  EXPECT_THAT(after.map.history.back(), HasSubstr("filter --remove=car: removed "));
  EXPECT_EQ(Filtered(after.map, Remove({"car"})).map.history, after.map.history);
}

TEST(FilterTest, KeepingAllChangesNothing) {
  proto::FilterOptions options;
  for (const char* role : {"ground", "movable", "critical", "unlabeled"})
    options.add_keep_roles(role);
  options.add_keep("building");
  const FilteredMap after = Filtered(ConnectedMap(), options);
  EXPECT_TRUE(after.report.IsEmpty());
  EXPECT_EQ(BytesOf(after.map), BytesOf(ConnectedMap()));
}

TEST(FilterTest, BytesDoNotDependOnThreads) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena one(1), four(4);
  for (const proto::FilterOptions& options : SomeFilters()) {
    const Map map = ConnectedMap();
    const auto filter = [&] { return BytesOf(Filtered(map, options).map); };
    EXPECT_EQ(one.execute(filter), four.execute(filter)) << options.ShortDebugString();
  }
}

TEST(FilterTest, ErrorsNameTheOption) {
  const auto error = [](const proto::FilterOptions& options) {
    return std::string(Filter(ConnectedMap(), options).status().message());
  };
  EXPECT_EQ(error({}),
            "nothing to remove: name labels or roles, a region, trajectories, min_hits or "
            "transient things");
  EXPECT_THAT(error(Remove({"cra"})), HasSubstr("remove: "));
  proto::FilterOptions options;
  options.add_polygon(1.);
  EXPECT_THAT(error(options), HasSubstr("polygon: has 1 numbers"));
  options.Clear();
  options.add_trajectories(1);
  options.add_trajectories(4);
  EXPECT_THAT(error(options), HasSubstr("nothing would be left"));
  options.Clear();
  options.add_keep_trajectories(7);
  EXPECT_THAT(error(options), HasSubstr("keep_trajectory: the map has no trajectory 7"));
}

}  // namespace
}  // namespace cartographer::map
