// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SCORE_PYRAMID_H_
#define CARTOGRAPHER_SCAN_MATCHING_SCORE_PYRAMID_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cartographer/scan_matching/byte_image.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::scan_matching {

// One level of a pyramid. With W = 2^log2_window, block (bx, by) stands for the W x W shifts by
// [bx * W, (bx + 1) * W) x [by * W, (by + 1) * W) cells, and BoundAt(plane, cell, block) is at
// least the agreement at cell + shift for every one of them: a sliding-window maximum.
//
// Maxima are not kept at every cell but at every step-th, step = W / 2^log2_phases, over windows
// that are wider by a step (at step 1 by nothing): that costs little tightness, and memory and
// building time shrink with the square of the step.
//
// For a fixed cell, neighbouring blocks are W cells apart. They lie side by side in memory: maxima
// are sorted by phase, which is their place within W cells, and what has the same phase makes a
// rectangle of its own. So a square of blocks is read as a few bytes from a few rows. Around each
// rectangle there are kMargin zeros, so that a square which touches it at all may be read whole.
class PyramidLevel {
 public:
  // The side of the largest square of blocks that is read at once, less one.
  static constexpr int kMargin = 7;

  PyramidLevel(int log2_window, int log2_phases)
      : log2_window_(log2_window), log2_phases_(log2_phases) {}

  // Adds planes, one for an image of agreements by cells (all with the same columns unless empty).
  void AddPlanes(const std::vector<ByteImage>& images);

  int log2_window() const { return log2_window_; }
  // Whether cells within a step of each other are looked up in the same place.
  bool merges_cells() const { return log2_window_ > log2_phases_; }
  const uint8_t* bytes() const { return bytes_.data(); }
  // From a row to the next, of all planes.
  int stride() const { return columns_; }
  size_t num_bytes() const { return bytes_.size(); }

  // Where a cell is looked up for block (0, 0): its place in units of blocks, and the offset of its
  // phase from the beginning of its plane.
  struct Place {
    int x, y;
    int phase_offset;
  };
  Place PlaceOf(int plane, int cell_x, int cell_y) const {
    const int log2_step = log2_window_ - log2_phases_;
    const int mask = (1 << log2_phases_) - 1;
    const int phase_x = (cell_x >> log2_step) & mask, phase_y = (cell_y >> log2_step) & mask;
    return {cell_x >> log2_window_, cell_y >> log2_window_,
            ((phase_y << log2_phases_) + phase_x) * planes_[plane].rows * columns_};
  }

  // The columns and rows at which a square of blocks can touch anything: its first block at place
  // (x, y) is at byte begin + phase_offset + (y - first_row) * stride() + (x - first_column).
  struct Window {
    int first_column, first_row;
    uint32_t num_columns, num_rows;
    int begin;
  };
  Window WindowOf(int plane) const {
    const Plane& p = planes_[plane];
    return {first_column_, p.first_row, static_cast<uint32_t>(columns_ - kMargin),
            static_cast<uint32_t>(p.rows - kMargin), p.begin};
  }

  // What the search looks up, one at a time and safe everywhere; 0 where nothing was hit.
  int BoundAt(int plane, const submap::CellIndex& cell, const submap::CellIndex& block) const;

 private:
  struct Plane {
    int first_row = 0;
    int rows = 0;   // with margins; kMargin if there is nothing
    int begin = 0;  // in bytes_
  };

  void AddPlane(const ByteImage& image);

  int log2_window_;
  int log2_phases_;
  int first_column_ = 0;
  int columns_ = kMargin;  // with margins
  std::vector<Plane> planes_;
  std::vector<uint8_t> bytes_;
};

// The agreement of a submap's grid with points, at full resolution (level 0, a plane for each layer
// of the model) and as bounds over ever larger blocks of shifts (a plane for each group).
// Immutable; may be used by several threads.
class ScorePyramid {
 public:
  ScorePyramid(const submap::SemanticGrid& grid, const ScoreModel& model);

  // Level 0 is exact, higher ones have larger blocks.
  int num_levels() const { return static_cast<int>(levels_.size()); }
  const PyramidLevel& level(int index) const { return levels_[index]; }
  // The plane of a level in which points of a layer are looked up.
  int PlaneOf(int level, int layer) const { return level == 0 ? layer : group_of_layer_[layer]; }

  size_t num_bytes() const;

 private:
  std::vector<int> group_of_layer_;
  std::vector<PyramidLevel> levels_;
};

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SCORE_PYRAMID_H_
