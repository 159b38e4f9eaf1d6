// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/scan_at_yaw.h"

#include <limits>
#include <utility>

namespace cartographer::scan_matching {

ScanAtYaw::ScanAtYaw(const ScorePyramid& pyramid, ScanCells cells,
                     const submap::CellIndex& first_shift)
    : pyramid_(pyramid),
      cells_(std::move(cells)),
      first_shift_(first_shift),
      levels_(pyramid.num_levels()),
      lookups_(cells_.cells.size() + 1) {}

const ScanAtYaw::LevelPoints& ScanAtYaw::PointsOf(int level) {
  if (levels_[level].points.empty()) levels_[level] = MakePoints(level);
  return levels_[level];
}

ScanAtYaw::LevelPoints ScanAtYaw::MakePoints(int level) const {
  const PyramidLevel& pyramid_level = pyramid_.level(level);
  LevelPoints result;
  result.points.resize(cells_.cells.size());
  LevelPoint* const points = result.points.data();
  size_t size = 0;
  for (const ScanCells::Layer& layer : cells_.layers) {
    const int plane = pyramid_.PlaneOf(level, layer.layer);
    if (result.planes.empty() || result.planes.back().plane != plane) {
      result.planes.push_back({plane, size, size});
    }
    const LevelPoint* const end = pyramid_level.merges_cells()
                                      ? AddMerged(pyramid_level, plane, layer, points + size)
                                      : AddEach(pyramid_level, plane, layer, points + size);
    size = end - points;
    result.planes.back().end = size;
  }
  result.points.resize(size);
  return result;
}

ScanAtYaw::LevelPoint* ScanAtYaw::AddEach(const PyramidLevel& level, int plane,
                                          const ScanCells::Layer& layer, LevelPoint* next) const {
  for (size_t i = layer.begin; i < layer.end; ++i) {
    const ScanCell& cell = cells_.cells[i];
    const auto place = level.PlaceOf(plane, cell.x + first_shift_.x(), cell.y + first_shift_.y());
    *next++ = {place.x, place.y, place.phase_offset, cell.weight};
  }
  return next;
}

ScanAtYaw::LevelPoint* ScanAtYaw::AddMerged(const PyramidLevel& level, int plane,
                                            const ScanCells::Layer& layer, LevelPoint* next) const {
  LevelPoint last{std::numeric_limits<int>::min(), 0, 0, 0};
  for (size_t i = layer.begin; i < layer.end; ++i) {
    const ScanCell& cell = cells_.cells[i];
    const auto place = level.PlaceOf(plane, cell.x + first_shift_.x(), cell.y + first_shift_.y());
    // Without a branch, as in MatchingScan::CellsAt.
    const bool same = (last.x == place.x) & (last.y == place.y) &
                      (last.phase_offset == place.phase_offset) &
                      (last.weight + cell.weight <= kMaxCellWeight);
    last = {place.x, place.y, place.phase_offset, cell.weight + (same ? last.weight : 0)};
    next += same ? 0 : 1;
    next[-1] = last;
  }
  return next;
}

size_t ScanAtYaw::LookUp(int level, const submap::CellIndex& first_block) {
  const LevelPoints& level_points = PointsOf(level);
  const PyramidLevel& pyramid_level = pyramid_.level(level);
  const uint32_t stride = pyramid_level.stride();
  Lookup* next = lookups_.data();
  for (const PlanePoints& plane : level_points.planes) {
    const PyramidLevel::Window window = pyramid_level.WindowOf(plane.plane);
    // Unsigned, so that what is far outside may wrap around.
    const uint32_t shift_x = first_block.x() - window.first_column;
    const uint32_t shift_y = first_block.y() - window.first_row;
    for (size_t i = plane.begin; i < plane.end; ++i) {
      const LevelPoint& point = level_points.points[i];
      const uint32_t column = point.x + shift_x, row = point.y + shift_y;
      // Written always and kept if inside: a branch would often be guessed wrong.
      *next = {static_cast<int32_t>(window.begin + point.phase_offset + row * stride + column),
               point.weight};
      next +=
          static_cast<int>(column < window.num_columns) & static_cast<int>(row < window.num_rows);
    }
  }
  return next - lookups_.data();
}

void ScanAtYaw::SumBlocks(int level, const submap::CellIndex& first_block, int side,
                          int32_t* sums) {
  const size_t num_lookups = LookUp(level, first_block);
  const PyramidLevel& pyramid_level = pyramid_.level(level);
  SumBlock(pyramid_level.bytes(), pyramid_level.stride(), side, lookups_.data(), num_lookups, sums);
}

}  // namespace cartographer::scan_matching
