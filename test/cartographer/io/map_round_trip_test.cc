// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <random>

#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_writer.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::RandomPose;
using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MapRoundTripTest : public ::testing::Test {
 protected:
  std::string Bytes(const map::Map& map, const std::string& name = "a") {
    const absl::Status status = WriteMap(map, directory_ / name);
    EXPECT_TRUE(status.ok()) << status;
    return ReadText(directory_ / name);
  }

  map::Map Read(const std::string& name) {
    absl::StatusOr<map::Map> map = ReadMap(directory_ / name);
    EXPECT_TRUE(map.ok()) << map.status();
    return map.ok() ? *std::move(map) : map::Map();
  }

  std::string WriteError(const map::Map& map) {
    const absl::Status status = WriteMap(map, directory_ / "bad");
    EXPECT_FALSE(std::filesystem::exists(directory_ / "bad"));
    return std::string(status.message());
  }

  TemporaryDirectory directory_;
};

void ExpectNear(const transform::Rigid3d& a, const transform::Rigid3d& b) {
  EXPECT_EQ(a.translation(), b.translation());
  EXPECT_EQ(a.rotation().coeffs(), b.rotation().coeffs());
}

// Points come back sorted by place, so they are compared as sets of neighbours.
void ExpectSameCloud(const sensor::LabeledPointCloud& actual,
                     const sensor::LabeledPointCloud& expected) {
  actual.CheckConsistent();
  ASSERT_EQ(actual.size(), expected.size());
  ASSERT_EQ(actual.intensities.size(), expected.intensities.size());
  ASSERT_EQ(actual.times.size(), expected.times.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    size_t best = 0;
    for (size_t j = 0; j < actual.size(); ++j) {
      if ((actual.positions[j] - expected.positions[i]).norm() <
          (actual.positions[best] - expected.positions[i]).norm()) {
        best = j;
      }
    }
    ASSERT_LT((actual.positions[best] - expected.positions[i]).norm(), 1e-3f);
    EXPECT_EQ(actual.labels[best], expected.labels[i]);
    EXPECT_NEAR(actual.certainties[best], expected.certainties[i], 0.5f / 255.f + 1e-6f);
    if (actual.intensities.empty()) continue;
    EXPECT_NEAR(actual.intensities[best], expected.intensities[i], 0.5f / 255.f + 1e-6f);
    EXPECT_NEAR(actual.times[best], expected.times[i], 0.6e-6f);
  }
}

TEST_F(MapRoundTripTest, EverythingComesBack) {
  const map::Map map = SmallMap(5, 60);
  Bytes(map);
  const map::Map read = Read("a");
  ASSERT_EQ(read.submaps.size(), map.submaps.size());
  for (const auto& [id, expected] : map.submaps) {
    const map::MapSubmap& actual = read.submaps.at(id);
    ExpectNear(actual.map_from_submap, expected.map_from_submap);
    ExpectNear(actual.submap->local_from_submap, expected.submap->local_from_submap);
    EXPECT_EQ(actual.submap->num_scans, expected.submap->num_scans);
    EXPECT_EQ(actual.submap->finished, expected.submap->finished);
    EXPECT_EQ(actual.submap->grid.resolution_m(), expected.submap->grid.resolution_m());
    EXPECT_EQ(actual.submap->grid.Labels(), expected.submap->grid.Labels());
    for (const sensor::Label label : expected.submap->grid.Labels()) {
      const auto layer = expected.submap->grid.LayerOf(label);
      const auto actual_layer = actual.submap->grid.LayerOf(label);
      ASSERT_EQ(actual_layer.size(), layer.size());
      for (const auto& [index, tile] : layer) EXPECT_EQ(actual_layer.at(index)->hits, tile->hits);
    }
    ExpectSameCloud(actual.submap->cloud, expected.submap->cloud);
  }
  ASSERT_EQ(read.nodes.size(), map.nodes.size());
  for (const auto& [id, expected] : map.nodes) {
    const map::MapNode& actual = read.nodes.at(id);
    EXPECT_EQ(actual.time, expected.time);
    ExpectNear(actual.map_from_node, expected.map_from_node);
    ExpectNear(actual.local_from_node, expected.local_from_node);
    ExpectSameCloud(*actual.cloud, *expected.cloud);
  }
  ASSERT_EQ(read.constraints.size(), map.constraints.size());
  for (size_t i = 0; i < map.constraints.size(); ++i) {
    EXPECT_EQ(read.constraints[i].submap_id, map.constraints[i].submap_id);
    EXPECT_EQ(read.constraints[i].node_id, map.constraints[i].node_id);
    EXPECT_EQ(read.constraints[i].kind, map.constraints[i].kind);
    EXPECT_EQ(read.constraints[i].translation_weight, map.constraints[i].translation_weight);
    EXPECT_EQ(read.constraints[i].rotation_weight, map.constraints[i].rotation_weight);
    ExpectNear(read.constraints[i].submap_from_node, map.constraints[i].submap_from_node);
  }
  EXPECT_EQ(read.labels.declaration().SerializeAsString(),
            map.labels.declaration().SerializeAsString());
  EXPECT_EQ(read.configuration_lua, map.configuration_lua);
  EXPECT_EQ(read.history, map.history);
}

TEST_F(MapRoundTripTest, WriteReadWriteIsByteIdentical) {
  const std::string first = Bytes(SmallMap(9, 300), "first");
  EXPECT_EQ(Bytes(Read("first"), "second"), first);
}

// More records than a batch holds, so that batches meet.
TEST_F(MapRoundTripTest, BytesDoNotDependOnThreads) {
  const map::Map map = SmallMap(80, 20);
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena one(1), four(4);
  const std::string from_one = one.execute([&] { return Bytes(map, "one"); });
  EXPECT_EQ(four.execute([&] { return Bytes(map, "four"); }), from_one);
  EXPECT_EQ(four.execute([&] { return Bytes(Read("one"), "again"); }), from_one);
}

TEST_F(MapRoundTripTest, EmptyThings) {
  const std::string empty = Bytes(map::Map(), "empty");
  EXPECT_EQ(Bytes(Read("empty"), "again"), empty);
  EXPECT_EQ(Read("empty").labels.size(), 1u);

  map::Map map = SmallMap(2, 0);  // empty clouds, empty grids
  Bytes(map, "clouds");
  EXPECT_EQ(Read("clouds").nodes.size(), 4u);
  EXPECT_EQ(Read("clouds").submaps.size(), 2u);
}

TEST_F(MapRoundTripTest, PosesSurviveWhateverTheirLastBits) {
  std::mt19937 random(11);
  map::Map map = SmallMap(2, 1);
  for (int i = 0; i < 2000; ++i) {
    map.constraints.push_back({{1, 0},
                               {1, 3},
                               RandomPose(&random) * RandomPose(&random),
                               1.,
                               1.,
                               map::Constraint::Kind::kInterSubmap});
  }
  const std::string first = Bytes(map, "first");
  EXPECT_EQ(Bytes(Read("first"), "second"), first);
}

TEST_F(MapRoundTripTest, WhatCannotBeReadIsNotWritten) {
  map::Map map = SmallMap(2, 3);
  auto cloud = std::make_shared<sensor::LabeledPointCloud>(*map.nodes.begin()->second.cloud);
  cloud->labels[1] = sensor::Label{5};
  map.nodes.begin()->second.cloud = cloud;
  EXPECT_THAT(WriteError(map), AllOf(HasSubstr(directory_ / "bad"),
                                     HasSubstr("node (1, 3): point 1: label 5 is not in the set")));

  cloud->labels[1] = sensor::kUnlabeled;
  cloud->certainties[2] = NAN;
  EXPECT_THAT(WriteError(map), HasSubstr("node (1, 3): point 2: certainty nan is not in [0, 1]"));
  cloud->certainties[2] = 1.f;
  cloud->positions[0].x() = 1e9f;
  EXPECT_THAT(WriteError(map), HasSubstr("node (1, 3): point 0 at (9.99996e+08,"));

  map = SmallMap(2, 3);
  map.constraints[1].node_id = {1, 9};
  EXPECT_THAT(WriteError(map), HasSubstr("constraint 1: node (1, 9) does not exist"));

  map = SmallMap(2, 3);
  map.nodes.begin()->second.map_from_node = transform::Rigid3d::Translation({NAN, 0., 0.});
  EXPECT_THAT(WriteError(map), HasSubstr("node (1, 3): the translation (nan, 0, 0) is not finite"));

  map = SmallMap(2, 3);
  auto submap = std::make_shared<submap::Submap>(0.1);
  submap->grid.AddHits(sensor::Label{9}, {0, 0});
  map.submaps.begin()->second.submap = submap;
  EXPECT_THAT(WriteError(map), HasSubstr("submap (1, 0): layer of label 9: not in the label set"));

  submap = std::make_shared<submap::Submap>(0.1);
  submap->grid.AddHits(sensor::Label{1}, {-9000, 0});
  submap->grid.AddHits(sensor::Label{1}, {9000, 9000});
  map.submaps.begin()->second.submap = submap;
  EXPECT_THAT(WriteError(map),
              HasSubstr("submap (1, 0): a grid of 18001 x 9001 cells is too large"));
}

TEST_F(MapRoundTripTest, UnwritablePlacesAreNamed) {
  const absl::Status status = WriteMap(SmallMap(2, 3), directory_ / "none/map.pbstream");
  EXPECT_THAT(std::string(status.message()), HasSubstr("none/map.pbstream"));
}

}  // namespace
}  // namespace cartographer::io
