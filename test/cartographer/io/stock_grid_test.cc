// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/stock_grid.h"

#include <random>

#include "test/cartographer/io/memory_peak.h"

namespace cartographer::io {
namespace {

using submap::CellIndex;
using submap::SemanticGrid;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using transform::Rigid3d;

constexpr sensor::Label kRoad{1}, kWall{2};

sensor::LabelMask Ground() {
  sensor::LabelMask mask;
  mask.Insert(kRoad);
  return mask;
}

Rigid3d Pose(double x, double y, double yaw) {
  return Rigid3d({x, y, 0.5}, Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())));
}

// The value of the cell that holds a point of the local frame, by the rule of map_limits.proto.
int ValueAt(const mapping::proto::Grid2D& grid, const Eigen::Vector2d& local) {
  const auto& limits = grid.limits();
  const int i = static_cast<int>(std::floor((limits.max().y() - local.y()) / limits.resolution()));
  const int j = static_cast<int>(std::floor((limits.max().x() - local.x()) / limits.resolution()));
  const int num_x = limits.cell_limits().num_x_cells(), num_y = limits.cell_limits().num_y_cells();
  return i < 0 || j < 0 || i >= num_x || j >= num_y ? 0 : grid.cells(j * num_x + i);
}

mapping::proto::Grid2D StockGrid(const std::vector<int>& cells, int num_x_cells) {
  mapping::proto::Grid2D grid;
  grid.mutable_limits()->set_resolution(0.5);
  grid.mutable_limits()->mutable_max()->set_x(1.);
  grid.mutable_limits()->mutable_max()->set_y(2.);
  grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(num_x_cells);
  grid.mutable_limits()->mutable_cell_limits()->set_num_y_cells(static_cast<int>(cells.size()) /
                                                                num_x_cells);
  for (const int cell : cells) grid.add_cells(cell);
  grid.mutable_probability_grid_2d();
  grid.set_min_correspondence_cost(0.1f);
  grid.set_max_correspondence_cost(0.9f);
  return grid;
}

std::string ErrorOf(const mapping::proto::Grid2D& grid) {
  return std::string(FromStockGrid(grid, Rigid3d()).status().message());
}

TEST(StockGridTest, EmptyGridHasOneUnknownCell) {
  const auto stock = ToStockGrid(SemanticGrid(0.2), Ground(), Rigid3d());
  ASSERT_TRUE(stock.ok());
  EXPECT_THAT(stock->cells(), ElementsAre(0));
  EXPECT_FALSE(stock->has_known_cells_box());
  EXPECT_EQ(FromStockGrid(*stock, Rigid3d())->num_tiles(), 0u);
}

TEST(StockGridTest, MoreHitsAreMoreCertain) {
  SemanticGrid grid(1.);
  for (int x = 0; x < 20; ++x) {
    grid.AddHits(kWall, {x, 0}, x + 1);
    grid.AddHits(kRoad, {x, 1}, x + 1);
  }
  const auto stock = ToStockGrid(grid, Ground(), Rigid3d());
  ASSERT_TRUE(stock.ok());
  for (int x = 0; x < 20; ++x) {
    const int wall = ValueAt(*stock, {x + 0.5, 0.5}), road = ValueAt(*stock, {x + 0.5, 1.5});
    EXPECT_LT(wall, 16384);
    EXPECT_GE(road, 16384);
    EXPECT_EQ(wall + road, 32768) << "odds are inverse";
    EXPECT_EQ(wall == 1, x >= 10);
    EXPECT_TRUE(x == 0 || x > 10 || wall < ValueAt(*stock, {x - 0.5, 0.5}));
  }
}

TEST(StockGridTest, WithoutRotationEveryCellIsExact) {
  std::mt19937 random(5);
  SemanticGrid grid(0.25);
  for (int i = 0; i < 500; ++i) {
    grid.AddHits(random() % 2 == 0 ? kWall : kRoad,
                 {static_cast<int>(random() % 100) - 50, static_cast<int>(random() % 60) - 10});
  }
  const Rigid3d local_from_submap = Pose(12.34, -5.67, 0.);
  const auto stock = ToStockGrid(grid, Ground(), local_from_submap);
  ASSERT_TRUE(stock.ok());
  EXPECT_EQ(stock->cells_size(), stock->limits().cell_limits().num_x_cells() *
                                     stock->limits().cell_limits().num_y_cells());
  const auto back = FromStockGrid(*stock, local_from_submap);
  ASSERT_TRUE(back.ok()) << back.status();
  for (int y = -12; y < 52; ++y) {
    for (int x = -52; x < 52; ++x) {
      const auto dominant = grid.Dominant({x, y});
      const Eigen::Vector3d centre =
          local_from_submap * Eigen::Vector3d((x + 0.5) * 0.25, (y + 0.5) * 0.25, 0.);
      const int value = ValueAt(*stock, centre.head<2>());
      EXPECT_EQ(value == 0, dominant.hits == 0);
      const int hits = dominant.label == kWall ? dominant.hits : 0;
      EXPECT_EQ(value > 0 && value<16384, hits> 0);
      EXPECT_EQ(back->Hits(sensor::kUnlabeled, {x, y}), std::min(hits, 11));
    }
  }
}

TEST(StockGridTest, RotatedSubmapsLoseNothingOccupied) {
  std::mt19937 random(6);
  SemanticGrid grid(0.1);
  for (int i = 0; i < 400; ++i) {
    grid.AddHits(kWall, {static_cast<int>(random() % 200), static_cast<int>(random() % 200)}, 3);
  }
  for (const double yaw : {0.3, 1.5707, -2.2, 3.1}) {
    const Rigid3d local_from_submap = Pose(-3., 40., yaw);
    const auto stock = ToStockGrid(grid, Ground(), local_from_submap);
    ASSERT_TRUE(stock.ok());
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        if (grid.Hits(kWall, {x, y}) == 0) continue;
        const Eigen::Vector3d centre =
            local_from_submap * Eigen::Vector3d((x + 0.5) * 0.1, (y + 0.5) * 0.1, 0.);
        const int value = ValueAt(*stock, centre.head<2>());
        EXPECT_TRUE(value > 0 && value < 16384) << x << " " << y << " " << yaw;
      }
    }
    // Nor is much added: at most the cell of the centre beside those that lie on the cell.
    const auto known = [](int value) { return value > 0; };
    const auto num_known = std::count_if(stock->cells().begin(), stock->cells().end(), known);
    EXPECT_LT(num_known, 400 * 1.5);
  }
}

TEST(StockGridTest, TooLargeGridsAreAnError) {
  SemanticGrid grid(0.1);
  grid.AddHits(kWall, {0, 0});
  grid.AddHits(kWall, {1 << 28, 3});
  EXPECT_THAT(std::string(ToStockGrid(grid, Ground(), Rigid3d()).status().message()),
              HasSubstr("a grid of 268435457 x 4 cells is too large"));
  EXPECT_EQ(CheckFitsStockGrid(grid, Rigid3d()), ToStockGrid(grid, Ground(), Rigid3d()).status());
  // What fits as it lies may not fit as it is turned.
  const auto turned =
      Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ())));
  SemanticGrid street(0.1);
  street.AddHits(kWall, {0, 0});
  street.AddHits(kWall, {1 << 16, 3});
  EXPECT_TRUE(CheckFitsStockGrid(street, Rigid3d()).ok());
  EXPECT_EQ(CheckFitsStockGrid(street, turned), ToStockGrid(street, Ground(), turned).status());
  EXPECT_FALSE(CheckFitsStockGrid(street, turned).ok());
}

TEST(StockGridTest, GridsThatWouldTakeAllMemoryAreAnError) {
  SemanticGrid grid(0.1);
  grid.AddHits(kWall, {0, 0});
  mapping::proto::Grid2D stock = *ToStockGrid(grid, Ground(), Rigid3d());
  const int num_cells = 17 * SemanticGrid::kTileSize * 1000 * 40;
  stock.mutable_limits()->mutable_cell_limits()->set_num_x_cells(1);
  stock.mutable_limits()->mutable_cell_limits()->set_num_y_cells(num_cells);
  stock.mutable_cells()->Resize(num_cells, 1);
  const MemoryPeak peak;
  EXPECT_THAT(std::string(FromStockGrid(stock, Rigid3d()).status().message()),
              HasSubstr("a grid with 524288 tiles or more"));
  EXPECT_LT(peak.bytes(), 500'000'000u);
}

TEST(StockGridTest, CellsLandWhereTheyLie) {
  // Two rows of three: index i runs along -y, j along -x. Only values below 16384 are occupied.
  const auto grid = FromStockGrid(StockGrid({0, 1, 0, 32767, 16000, 20000}, 3), Rigid3d());
  ASSERT_TRUE(grid.ok()) << grid.status();
  // (i, j) = (1, 0): centre (0.75, 1.25); (1, 1): centre (0.25, 1.25).
  EXPECT_EQ(grid->Hits(sensor::kUnlabeled, {1, 2}), 11);
  EXPECT_EQ(grid->Hits(sensor::kUnlabeled, {0, 2}), 1);
  EXPECT_EQ(grid->num_tiles(), 1u);
  // A submap at (0.75, 0) whose x axis points along the local y: (0.75, 1.25) is (1.25, 0) there.
  const auto turned = FromStockGrid(StockGrid({0, 1, 0, 0, 0, 0}, 3), Pose(0.75, 0., M_PI / 2.));
  EXPECT_EQ(turned->Hits(sensor::kUnlabeled, {2, 0}), 11);
}

TEST(StockGridTest, OldFilesWithoutCostsHaveTheUsualOnes) {
  mapping::proto::Grid2D old = StockGrid({1}, 1);
  old.clear_min_correspondence_cost();
  old.clear_max_correspondence_cost();
  EXPECT_EQ(FromStockGrid(old, Rigid3d())->Hits(sensor::kUnlabeled, {1, 3}), 11);
}

TEST(StockGridTest, NonsenseIsAnError) {
  mapping::proto::Grid2D grid = StockGrid({0, 0}, 1);
  grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(2);
  EXPECT_THAT(ErrorOf(grid), HasSubstr("a grid of 2 x 2 cells has 2 values"));
  grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(-1);
  EXPECT_THAT(ErrorOf(grid), HasSubstr("a grid of -1 x 2"));
  EXPECT_THAT(ErrorOf(StockGrid({0, -1}, 1)), HasSubstr("cell 1 of the grid has the value -1"));
  EXPECT_THAT(ErrorOf(StockGrid({40000}, 1)), HasSubstr("value 40000"));
  for (const double resolution : {0., -1., 1e9, std::nan("")}) {
    grid = StockGrid({1}, 1);
    grid.mutable_limits()->set_resolution(resolution);
    EXPECT_THAT(ErrorOf(grid), HasSubstr("a grid with cells of"));
  }
  for (const double x : {1e300, std::nan("")}) {
    grid = StockGrid({1}, 1);
    grid.mutable_limits()->mutable_max()->set_x(x);
    EXPECT_THAT(ErrorOf(grid), HasSubstr("lies too far from its submap"));
  }
  grid = StockGrid({1}, 1);
  grid.set_max_correspondence_cost(0.05f);
  EXPECT_THAT(ErrorOf(grid), HasSubstr("costs from 0.1 to 0.05"));
  grid.mutable_tsdf_2d();
  EXPECT_EQ(FromStockGrid(grid, Rigid3d()).status().code(), absl::StatusCode::kUnimplemented);
}

}  // namespace
}  // namespace cartographer::io
