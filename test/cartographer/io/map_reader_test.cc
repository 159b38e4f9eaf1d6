// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cartographer/io/map_writer.h"
#include "glog/logging.h"
#include "test/cartographer/io/memory_peak.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;

class MapPartsTest : public ::testing::Test {
 protected:
  MapPartsTest() { CHECK(WriteMap(SmallMap(20, 100), path_).ok()); }

  map::Map Read(const MapParts& parts) {
    auto map = ReadMapParts(path_, parts);
    CHECK(map.ok()) << map.status();
    return *std::move(map);
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_ / "map.pbstream";
};

TEST_F(MapPartsTest, PartsAreAsInTheWhole) {
  const map::Map whole = *ReadMap(path_);
  for (int bits = 0; bits < 8; ++bits) {
    const MapParts parts{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
    const map::Map map = Read(parts);
    EXPECT_EQ(map.constraints.size(), whole.constraints.size());
    EXPECT_EQ(map.history, whole.history);
    ASSERT_EQ(map.nodes.size(), whole.nodes.size());
    for (const auto& [id, node] : whole.nodes) {
      EXPECT_EQ(map.nodes.at(id).time, node.time);
      EXPECT_EQ(map.nodes.at(id).map_from_node.Matrix(), node.map_from_node.Matrix());
      EXPECT_EQ(map.nodes.at(id).cloud->size(), parts.node_clouds ? node.cloud->size() : 0);
    }
    ASSERT_EQ(map.submaps.size(), parts.grids || parts.submap_clouds ? whole.submaps.size() : 0);
    for (const auto& [id, placed] : map.submaps) {
      const submap::Submap& submap = *whole.submaps.at(id).submap;
      EXPECT_EQ(placed.submap->cloud.size(), parts.submap_clouds ? submap.cloud.size() : 0);
      EXPECT_EQ(placed.submap->grid.num_tiles(), parts.grids ? submap.grid.num_tiles() : 0);
      EXPECT_EQ(placed.submap->num_scans, submap.num_scans);
    }
  }
}

TEST_F(MapPartsTest, WhatIsLeftOutTakesNoMemory) {
  const auto peak = [this](const MapParts& parts) {
    const MemoryPeak memory;
    Read(parts);
    return memory.bytes();
  };
  EXPECT_LT(peak({false, false, true}), peak({true, true, true}) / 2);
}

}  // namespace
}  // namespace cartographer::io
