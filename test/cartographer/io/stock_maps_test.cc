// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_summary.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/io/pose_proto.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::RealDataDirectory;
using semantic_kiss_testing::TemporaryDirectory;

// Maps that stock Cartographer wrote.
class StockMapsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::optional<std::string> data = RealDataDirectory();
    if (!data.has_value()) GTEST_SKIP() << "no maps of stock Cartographer";
    stock_maps_ = *data + "/pbstream/";
  }

  std::string Path(const std::string& name) const { return stock_maps_ + name; }

  TemporaryDirectory directory_;
  std::string stock_maps_;
};

int CountConstraints(const map::Map& map, map::Constraint::Kind kind) {
  return static_cast<int>(
      std::count_if(map.constraints.begin(), map.constraints.end(),
                    [kind](const map::Constraint& constraint) { return constraint.kind == kind; }));
}

TEST_F(StockMapsTest, SixteenScansOfKitti) {
  const absl::StatusOr<map::Map> map = ReadMap(Path("stock_kitti_16_scans.pbstream"));
  ASSERT_TRUE(map.ok()) << map.status();
  EXPECT_EQ(map->nodes.size(), 16u);
  ASSERT_EQ(map->submaps.size(), 1u);
  const submap::Submap& submap = *map->submaps.begin()->second.submap;
  EXPECT_EQ(submap.grid.Labels(), std::vector<sensor::Label>{sensor::kUnlabeled});
  EXPECT_TRUE(map->configuration_lua.empty());
  for (const auto& [id, node] : map->nodes) EXPECT_GT(node.cloud->size(), 500u);
  // 12 m ahead in 1.5 s.
  EXPECT_NEAR((map->nodes.rbegin()->second.map_from_node.translation() -
               map->nodes.begin()->second.map_from_node.translation())
                  .norm(),
              11.7, 0.3);
}

// The share of the points of a submap's own nodes that fall within a cell of an occupied one, after
// a shift along the submap's x axis.
std::map<submap::SubmapId, double> ShareOnOccupiedCells(const map::Map& map, double shift_m) {
  std::map<submap::SubmapId, int64_t> num_points, num_on_cells;
  for (const map::Constraint& constraint : map.constraints) {
    if (constraint.kind != map::Constraint::Kind::kIntraSubmap) continue;
    const submap::SemanticGrid& grid = map.submaps.at(constraint.submap_id).submap->grid;
    for (const Eigen::Vector3f& point : map.nodes.at(constraint.node_id).cloud->positions) {
      const Eigen::Vector3d in_submap = constraint.submap_from_node * point.cast<double>();
      const submap::CellIndex cell = grid.CellOf(
          {static_cast<float>(in_submap.x() + shift_m), static_cast<float>(in_submap.y())});
      bool hit = false;
      for (int i = 0; i < 9; ++i) {
        hit |= grid.Hits(sensor::kUnlabeled, cell + submap::CellIndex(i % 3 - 1, i / 3 - 1)) > 0;
      }
      num_on_cells[constraint.submap_id] += hit;
      ++num_points[constraint.submap_id];
    }
  }
  std::map<submap::SubmapId, double> shares;
  for (const auto& [id, count] : num_points) {
    shares[id] = static_cast<double>(num_on_cells[id]) / static_cast<double>(count);
  }
  return shares;
}

// What the clouds hit must be what the grid has: this ties frames, axes and the grid's origin.
TEST_F(StockMapsTest, CloudsFallOntoOccupiedCells) {
  const absl::StatusOr<map::Map> map = ReadMap(Path("stock_aces.pbstream"));
  ASSERT_TRUE(map.ok()) << map.status();
  const auto shares = ShareOnOccupiedCells(*map, 0.), shifted = ShareOnOccupiedCells(*map, 0.4);
  ASSERT_EQ(shares.size(), 32u);
  for (const auto& [id, share] : shares) {
    EXPECT_GT(share, 0.9) << Name(id);
    EXPECT_LT(shifted.at(id), 0.75) << Name(id) << ": any place would do";
  }
}

TEST_F(StockMapsTest, Aces) {
  const absl::StatusOr<map::Map> map = ReadMap(Path("stock_aces.pbstream"));
  ASSERT_TRUE(map.ok()) << map.status();
  EXPECT_EQ(map->nodes.size(), 2822u);
  EXPECT_EQ(map->submaps.size(), 32u);
  EXPECT_EQ(CountConstraints(*map, map::Constraint::Kind::kIntraSubmap), 5554);
  EXPECT_EQ(CountConstraints(*map, map::Constraint::Kind::kInterSubmap), 674);
}

TEST_F(StockMapsTest, OnceReadTheyAreWrittenAlike) {
  const absl::StatusOr<map::Map> map = ReadMap(Path("stock_kitti_16_scans.pbstream"));
  ASSERT_TRUE(map.ok()) << map.status();
  ASSERT_TRUE(WriteMap(*map, directory_ / "first").ok());
  const absl::StatusOr<map::Map> again = ReadMap(directory_ / "first");
  ASSERT_TRUE(again.ok()) << again.status();
  ASSERT_TRUE(WriteMap(*again, directory_ / "second").ok());
  EXPECT_EQ(ReadText(directory_ / "second"), ReadText(directory_ / "first"));
}

TEST_F(StockMapsTest, Summary) {
  const absl::StatusOr<MapSummary> summary = ReadMapSummary(Path("stock_aces.pbstream"));
  ASSERT_TRUE(summary.ok()) << summary.status();
  EXPECT_EQ(summary->file_bytes, std::filesystem::file_size(Path("stock_aces.pbstream")));
  EXPECT_FALSE(summary->made_by_us);
  EXPECT_EQ(summary->num_intra_constraints, 5554);
  EXPECT_EQ(summary->num_inter_constraints, 674);
  ASSERT_EQ(summary->trajectories.size(), 1u);
  EXPECT_EQ(summary->trajectories[0].num_nodes, 2822);
  EXPECT_EQ(summary->trajectories[0].num_submaps, 32);
  uint64_t stored = 8;  // the magic number
  for (const MapSummary::Kind& kind : summary->kinds) stored += kind.stored_bytes;
  EXPECT_EQ(stored, summary->file_bytes);
  const auto odometry = std::find_if(summary->kinds.begin(), summary->kinds.end(),
                                     [](const auto& kind) { return kind.name == "odometry_data"; });
  ASSERT_NE(odometry, summary->kinds.end());
  EXPECT_EQ(odometry->count, 7374);
}

}  // namespace
}  // namespace cartographer::io
