// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/score_pyramid.h"

#include <algorithm>
#include <iterator>

#include "cartographer/scan_matching/score_layers.h"
#include "glog/logging.h"

namespace cartographer::scan_matching {
namespace {

struct LevelShape {
  int log2_window;
  int log2_phases;
};
// From one level to the next blocks grow by 4 or 8, the squares that are summed at once. Found by
// measurement (test/benchmark/scan_matching_benchmark.cc).
constexpr LevelShape kLevels[] = {{0, 0}, {3, 3}, {5, 3}, {7, 3}};

// Copies the pixels begin, begin + step, ... before end.
void CopyEvery(int step, const uint8_t* begin, const uint8_t* end, uint8_t* target) {
  if (step == 1) {
    std::copy(begin, end, target);
    return;
  }
  for (const uint8_t* pixel = begin; pixel < end; pixel += step) *target++ = *pixel;
}

// The maximum over the layers of each group.
std::vector<ByteImage> GroupMaxima(const std::vector<ByteImage>& layers, const ScoreModel& model) {
  std::vector<ByteImage> groups;
  for (int group = 0; group < model.num_groups(); ++group) {
    std::vector<const ByteImage*> members;
    for (int layer = 0; layer < model.num_layers(); ++layer) {
      if (model.GroupOf(layer) == group && layers[layer].height > 0) {
        members.push_back(&layers[layer]);
      }
    }
    if (members.empty()) {
      groups.emplace_back(0, 0, 0, 0);
      continue;
    }
    int begin = members[0]->y0, end = begin;
    for (const ByteImage* member : members) {
      begin = std::min(begin, member->y0);
      end = std::max(end, member->y0 + member->height);
    }
    groups.emplace_back(members[0]->x0, begin, members[0]->width, end - begin);
    for (const ByteImage* member : members) MaxInto(*member, &groups.back());
  }
  return groups;
}

}  // namespace

void PyramidLevel::AddPlanes(const std::vector<ByteImage>& images) {
  const int log2_step = log2_window_ - log2_phases_;
  // Windows in units of steps: a window that begins anywhere in a step ends in a further one.
  const int window = (1 << log2_phases_) - (log2_step == 0 ? 1 : 0) + 1;
  for (const ByteImage& image : images) {
    if (image.height == 0) {
      planes_.push_back({0, kMargin, 0});
    } else if (log2_window_ == 0) {
      AddPlane(image);
    } else if (log2_step == 0) {
      AddPlane(SlidingMaxima(image, window));
    } else {
      AddPlane(SlidingMaxima(BlockMaxima(image, log2_step), window));
    }
  }
}

void PyramidLevel::AddPlane(const ByteImage& maxima) {
  const int phases = 1 << log2_phases_;
  const auto block_of = [this](int x) { return x >> log2_phases_; };
  first_column_ = block_of(maxima.x0) - kMargin;
  columns_ = block_of(maxima.x0 + maxima.width - 1) + 1 + kMargin - first_column_;
  Plane plane;
  plane.first_row = block_of(maxima.y0) - kMargin;
  plane.rows = block_of(maxima.y0 + maxima.height - 1) + 1 + kMargin - plane.first_row;
  plane.begin = static_cast<int>(bytes_.size());
  CHECK_LT(bytes_.size() + size_t(phases) * phases * plane.rows * columns_, size_t{1} << 31);
  bytes_.resize(bytes_.size() + size_t(phases) * phases * plane.rows * columns_);
  for (int y = maxima.y0; y < maxima.y0 + maxima.height; ++y) {
    const uint8_t* const source = maxima.Row(y);
    for (int phase_x = 0; phase_x < phases; ++phase_x) {
      const int phase = (y & (phases - 1)) * phases + phase_x;
      uint8_t* const target = &bytes_[plane.begin + phase * plane.rows * columns_ +
                                      (block_of(y) - plane.first_row) * columns_];
      const int first = (phase_x - maxima.x0) & (phases - 1);
      CopyEvery(phases, source + first, source + maxima.width,
                target + (block_of(maxima.x0 + first) - first_column_));
    }
  }
  planes_.push_back(plane);
}

int PyramidLevel::BoundAt(int plane, const submap::CellIndex& cell,
                          const submap::CellIndex& block) const {
  const Place place = PlaceOf(plane, cell.x(), cell.y());
  const Window window = WindowOf(plane);
  const uint32_t column = place.x + block.x() - window.first_column;
  const uint32_t row = place.y + block.y() - window.first_row;
  if (column >= window.num_columns || row >= window.num_rows) return 0;
  return bytes_[window.begin + place.phase_offset + row * stride() + column];
}

ScorePyramid::ScorePyramid(const submap::SemanticGrid& grid, const ScoreModel& model) {
  for (int layer = 0; layer < model.num_layers(); ++layer) {
    group_of_layer_.push_back(model.GroupOf(layer));
  }
  levels_.reserve(std::size(kLevels));
  const std::vector<ByteImage> layers = ScoreLayers(grid, model);
  const std::vector<ByteImage> groups = GroupMaxima(layers, model);
  for (const LevelShape& shape : kLevels) {
    levels_.emplace_back(shape.log2_window, shape.log2_phases);
    levels_.back().AddPlanes(shape.log2_window == 0 ? layers : groups);
  }
}

size_t ScorePyramid::num_bytes() const {
  size_t sum = sizeof(*this);
  for (const PyramidLevel& level : levels_) sum += level.num_bytes();
  return sum;
}

}  // namespace cartographer::scan_matching
