// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/scan_at_yaw.h"

#include <utility>

namespace cartographer::scan_matching {

ScanAtYaw::ScanAtYaw(const ScorePyramid& pyramid, std::vector<ScanCell> cells)
    : pyramid_(pyramid), cells_(std::move(cells)), levels_(pyramid.num_levels()) {}

const ScanAtYaw::LevelPoints& ScanAtYaw::PointsOf(int level) {
  if (levels_[level].points.empty()) levels_[level] = MakePoints(level);
  return levels_[level];
}

ScanAtYaw::LevelPoints ScanAtYaw::MakePoints(int level) const {
  const PyramidLevel& pyramid_level = pyramid_.level(level);
  LevelPoints result;
  result.points.reserve(cells_.size());
  int last_plane = -1;
  for (const ScanCell& cell : cells_) {
    const int plane = pyramid_.PlaneOf(level, cell.layer);
    const auto place = pyramid_level.PlaceOf(plane, cell.cell);
    if (plane != last_plane) {
      result.planes.push_back({plane, result.points.size(), result.points.size()});
      last_plane = plane;
    } else {
      LevelPoint& last = result.points.back();
      if (last.x == place.x && last.y == place.y && last.phase_offset == place.phase_offset &&
          last.weight + cell.weight <= kMaxCellWeight) {
        last.weight += cell.weight;
        continue;
      }
    }
    result.points.push_back({place.x, place.y, place.phase_offset, cell.weight});
    result.planes.back().end = result.points.size();
  }
  return result;
}

void ScanAtYaw::LookUp(int level, const submap::CellIndex& first_block) {
  const LevelPoints& level_points = PointsOf(level);
  const PyramidLevel& pyramid_level = pyramid_.level(level);
  const uint32_t stride = pyramid_level.stride();
  lookups_.resize(level_points.points.size() + 1);
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
  lookups_.resize(next - lookups_.data());
}

void ScanAtYaw::SumBlocks(int level, const submap::CellIndex& first_block, int side,
                          int32_t* sums) {
  LookUp(level, first_block);
  const PyramidLevel& pyramid_level = pyramid_.level(level);
  SumBlock(pyramid_level.bytes(), pyramid_level.stride(), side, &lookups_, sums);
}

}  // namespace cartographer::scan_matching
