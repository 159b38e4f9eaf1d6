// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/stock_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/semantic_grid_proto.h"

namespace cartographer::io {
namespace {

using submap::CellIndex;
using submap::SemanticGrid;

constexpr double kMinCost = 0.1;
constexpr double kMaxCost = 0.9;
constexpr int kMaxValue = 32767;
constexpr double kOddsPerHit = 11. / 9.;
// At 3 bytes a cell such a grid stays below the limit of a record.
constexpr int64_t kMaxCells = 20'000'000;
// Values below this are rather occupied than free.
constexpr int kMiddleValue = 1 + (kMaxValue - 1) / 2;

using Box = SemanticGrid::CellBox;

int64_t NumCells(const Box& box) {
  const Eigen::Array<int64_t, 2, 1> size = box.max.cast<int64_t>() - box.min.cast<int64_t>();
  return size.x() * size.y();
}

// One value a cell of a box, row by row.
struct Raster {
  explicit Raster(const Box& box) : box(box), values(NumCells(box)) {}
  bool Contains(const CellIndex& cell) const {
    return (cell >= box.min).all() && (cell < box.max).all();
  }
  uint16_t& At(const CellIndex& cell) {
    const CellIndex offset = cell - box.min;
    return values[size_t(offset.y()) * (box.max.x() - box.min.x()) + offset.x()];
  }

  Box box;
  std::vector<uint16_t> values;
};

uint16_t StockValue(int hits, bool ground) {
  const double odds = std::pow(kOddsPerHit, ground ? -hits : hits);
  const double cost = std::clamp(1. / (1. + odds), kMinCost, kMaxCost);
  return static_cast<uint16_t>(
      1 + std::lround((cost - kMinCost) / (kMaxCost - kMinCost) * (kMaxValue - 1)));
}

// The values for the numbers of hits up to which they still change.
struct ValueTable {
  ValueTable() {
    for (int hits = 1; hits <= kMaxHits; ++hits) {
      occupied[hits] = StockValue(hits, false);
      ground[hits] = StockValue(hits, true);
    }
  }
  static constexpr int kMaxHits = 16;
  uint16_t occupied[kMaxHits + 1] = {};
  uint16_t ground[kMaxHits + 1] = {};
};

using DominantTiles = std::map<SemanticGrid::TileIndex, SemanticGrid::DominantTile>;

template <typename Body>
void ForEachHitCell(const DominantTiles& tiles, const Body& body) {
  for (const auto& [index, tile] : tiles) {
    const CellIndex corner = CellIndex(index.x, index.y) * SemanticGrid::kTileSize;
    for (int i = 0; i < static_cast<int>(tile.hits.size()); ++i) {
      if (tile.hits[i] == 0) continue;
      body(CellIndex(corner + CellIndex(i % SemanticGrid::kTileSize, i / SemanticGrid::kTileSize)),
           tile.labels[i], tile.hits[i]);
    }
  }
}

Box BoxOfHits(const DominantTiles& tiles) {
  Box box{CellIndex::Constant(std::numeric_limits<int>::max()),
          CellIndex::Constant(std::numeric_limits<int>::min())};
  ForEachHitCell(tiles, [&box](const CellIndex& cell, sensor::Label, int) {
    box.min = box.min.min(cell);
    box.max = box.max.max(cell + 1);
  });
  return box.Empty() ? Box() : box;
}

absl::Status CheckExtent(const Box& box) {
  if (NumCells(box) <= kMaxCells) return absl::OkStatus();
  const CellIndex size = box.max - box.min;
  return absl::InvalidArgumentError(absl::StrCat(
      "a grid of ", size.x(), " x ", size.y(),
      " cells is too large for a record; use smaller submaps, larger cells or a shorter range"));
}

// Rotation about the vertical from the submap's axes to the local ones.
Eigen::Rotation2Dd HeadingOf(const transform::Rigid3d& local_from_submap) {
  return Eigen::Rotation2Dd(transform::Yaw(local_from_submap.rotation()));
}

CellIndex RotatedCell(const Eigen::Matrix2d& rotation, const CellIndex& cell) {
  return (rotation * (cell.cast<double>() + 0.5).matrix()).array().floor().cast<int>();
}

Box RotatedBox(const Eigen::Matrix2d& rotation, const Box& box) {
  Eigen::AlignedBox2d bounds;
  for (const int x : {box.min.x(), box.max.x()}) {
    for (const int y : {box.min.y(), box.max.y()}) bounds.extend(rotation * Eigen::Vector2d(x, y));
  }
  return {bounds.min().array().floor().cast<int>(), bounds.max().array().ceil().cast<int>()};
}

Raster Rotated(Raster source, const Eigen::Matrix2d& rotation) {
  Raster target(RotatedBox(rotation, source.box));
  const Eigen::Matrix2d inverse = rotation.transpose();
  for (int y = target.box.min.y(); y < target.box.max.y(); ++y) {
    for (int x = target.box.min.x(); x < target.box.max.x(); ++x) {
      const CellIndex below = RotatedCell(inverse, {x, y});
      if (source.Contains(below)) target.At({x, y}) = source.At(below);
    }
  }
  for (int y = source.box.min.y(); y < source.box.max.y(); ++y) {
    for (int x = source.box.min.x(); x < source.box.max.x(); ++x) {
      const uint16_t value = source.At({x, y});
      if (value == 0 || value > kMiddleValue) continue;
      uint16_t& marked = target.At(RotatedCell(rotation, {x, y}));
      if (marked == 0 || marked > value) marked = value;
    }
  }
  return target;
}

// Turns the raster's rows, which run along +x, into Cartographer's, which run along -y.
mapping::proto::Grid2D ToProto(Raster raster, double resolution_m, const Eigen::Vector2d& origin) {
  mapping::proto::Grid2D proto;
  const CellIndex size = raster.box.max - raster.box.min;
  const Eigen::Vector2d max = origin + raster.box.max.cast<double>().matrix() * resolution_m;
  mapping::proto::MapLimits& limits = *proto.mutable_limits();
  limits.set_resolution(resolution_m);
  limits.mutable_max()->set_x(max.x());
  limits.mutable_max()->set_y(max.y());
  limits.mutable_cell_limits()->set_num_x_cells(size.y());
  limits.mutable_cell_limits()->set_num_y_cells(size.x());
  proto.mutable_cells()->Reserve(size.x() * size.y());
  Eigen::AlignedBox2i known;
  for (int j = 0; j < size.x(); ++j) {
    for (int i = 0; i < size.y(); ++i) {
      const uint16_t value = raster.At(raster.box.max - 1 - CellIndex(j, i));
      proto.mutable_cells()->AddAlreadyReserved(value);
      if (value != 0) known.extend(Eigen::Vector2i(i, j));
    }
  }
  if (!known.isEmpty()) {
    proto.mutable_known_cells_box()->set_min_x(known.min().x());
    proto.mutable_known_cells_box()->set_min_y(known.min().y());
    proto.mutable_known_cells_box()->set_max_x(known.max().x());
    proto.mutable_known_cells_box()->set_max_y(known.max().y());
  }
  proto.mutable_probability_grid_2d();
  proto.set_min_correspondence_cost(kMinCost);
  proto.set_max_correspondence_cost(kMaxCost);
  return proto;
}

absl::Status CheckStockGrid(const mapping::proto::Grid2D& proto) {
  if (!proto.has_probability_grid_2d()) {
    return absl::UnimplementedError("only grids of probabilities can be opened");
  }
  const mapping::proto::MapLimits& limits = proto.limits();
  const int64_t num_x_cells = limits.cell_limits().num_x_cells();
  const int64_t num_y_cells = limits.cell_limits().num_y_cells();
  if (num_x_cells < 0 || num_y_cells < 0 || num_x_cells * num_y_cells != proto.cells_size()) {
    return absl::DataLossError(absl::StrCat("a grid of ", num_x_cells, " x ", num_y_cells,
                                            " cells has ", proto.cells_size(), " values"));
  }
  if (!(limits.resolution() >= 1e-3 && limits.resolution() <= 1e3)) {
    return absl::DataLossError(
        absl::StrCat("a grid with cells of ", limits.resolution(), " m, outside [0.001, 1000]"));
  }
  const float min = proto.min_correspondence_cost();
  const float max = proto.max_correspondence_cost();
  const bool old_format = min == 0.f && max == 0.f;
  if (old_format || (min >= 0.f && min < max && max <= 1.f)) return absl::OkStatus();
  return absl::DataLossError(absl::StrCat("costs from ", min, " to ", max, " cannot be"));
}

// Hits of a cell whose value stands for `cost`; 0 unless it is rather occupied than free.
int HitsOfCost(double cost) {
  constexpr double kSmallestCost = 1e-3;
  if (cost >= 0.5) return 0;
  const double odds = 1. / std::max(cost, kSmallestCost) - 1.;
  return std::max(1, static_cast<int>(std::lround(std::log(odds) / std::log(kOddsPerHit))));
}

// Of the box as it is, and as it is turned to the local axes.
absl::Status CheckExtents(const Box& box, const Eigen::Matrix2d& rotation) {
  RETURN_IF_ERROR(CheckExtent(box));
  return CheckExtent(RotatedBox(rotation, box));
}

}  // namespace

absl::Status CheckFitsStockGrid(const SemanticGrid& grid,
                                const transform::Rigid3d& local_from_submap) {
  const Eigen::Matrix2d rotation = HeadingOf(local_from_submap).toRotationMatrix();
  // Whole tiles mostly tell.
  if (CheckExtents(grid.Bounds(), rotation).ok()) return absl::OkStatus();
  return CheckExtents(BoxOfHits(grid.DominantTiles()), rotation);
}

absl::StatusOr<mapping::proto::Grid2D> ToStockGrid(const SemanticGrid& grid,
                                                   const sensor::LabelMask& ground,
                                                   const transform::Rigid3d& local_from_submap) {
  static const ValueTable table;
  const DominantTiles tiles = grid.DominantTiles();
  Box box = BoxOfHits(tiles);
  // Cartographer cannot hold a grid without cells.
  if (box.Empty()) box.max = box.min + 1;
  const Eigen::Matrix2d rotation = HeadingOf(local_from_submap).toRotationMatrix();
  RETURN_IF_ERROR(CheckExtents(box, rotation));
  Raster raster(box);
  ForEachHitCell(tiles, [&](const CellIndex& cell, sensor::Label label, int hits) {
    const int row = std::min(hits, ValueTable::kMaxHits);
    raster.At(cell) = ground.Contains(label) ? table.ground[row] : table.occupied[row];
  });
  if (!rotation.isIdentity(0.)) raster = Rotated(std::move(raster), rotation);
  return ToProto(std::move(raster), grid.resolution_m(), local_from_submap.translation().head<2>());
}

absl::StatusOr<SemanticGrid> FromStockGrid(const mapping::proto::Grid2D& proto,
                                           const transform::Rigid3d& local_from_submap) {
  RETURN_IF_ERROR(CheckStockGrid(proto));
  const double resolution_m = proto.limits().resolution();
  SemanticGrid grid(resolution_m);
  const bool old_format = proto.max_correspondence_cost() == 0.f;
  const double min_cost = old_format ? kMinCost : proto.min_correspondence_cost();
  const double max_cost = old_format ? kMaxCost : proto.max_correspondence_cost();
  const Eigen::Matrix2d submap_from_local =
      HeadingOf(local_from_submap).inverse().toRotationMatrix();
  const Eigen::Vector2d max(proto.limits().max().x(), proto.limits().max().y());
  const Eigen::Vector2d corner = (max - local_from_submap.translation().head<2>()) / resolution_m;
  constexpr double kMaxDistance_cells = 1e8;
  if (!(corner.cwiseAbs().maxCoeff() <= kMaxDistance_cells)) {
    return absl::DataLossError(absl::StrCat("the grid's corner (", max.x(), ", ", max.y(),
                                            ") m lies too far from its submap"));
  }
  const int num_x_cells = proto.limits().cell_limits().num_x_cells();
  for (int cell = 0; cell < proto.cells_size(); ++cell) {
    const int value = proto.cells(cell);
    if (value < 0 || value > kMaxValue) {
      return absl::DataLossError(
          absl::StrCat("cell ", cell, " of the grid has the value ", value, ", over 32767"));
    }
    if (value == 0) continue;
    const int hits = HitsOfCost(min_cost + (value - 1) * (max_cost - min_cost) / (kMaxValue - 1));
    if (hits == 0) continue;
    // Centres on the border between two cells must all fall to the same side.
    constexpr double kTieBreak = 1e-6;
    const Eigen::Vector2d centre =
        corner - Eigen::Vector2d(cell / num_x_cells + 0.5, cell % num_x_cells + 0.5);
    grid.AddHits(sensor::kUnlabeled,
                 ((submap_from_local * centre).array() + kTieBreak).floor().cast<int>(), hits);
    // At the limit, not beyond it, where the grid would take twice as much to hold one tile more.
    if (grid.num_tiles() >= kMaxTiles) {
      return absl::DataLossError(absl::StrCat("a grid with ", kMaxTiles, " tiles or more"));
    }
  }
  return grid;
}

}  // namespace cartographer::io
