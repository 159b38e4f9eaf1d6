// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SCAN_AT_YAW_H_
#define CARTOGRAPHER_SCAN_MATCHING_SCAN_AT_YAW_H_

#include <cstdint>
#include <vector>

#include "cartographer/scan_matching/block_sums.h"
#include "cartographer/scan_matching/matching_scan.h"
#include "cartographer/scan_matching/score_pyramid.h"

namespace cartographer::scan_matching {

// The scan at one heading, which sums bounds over squares of blocks of shifts. What it needs of a
// level it prepares when that is first asked for. For one thread; `pyramid` must outlive it.
class ScanAtYaw {
 public:
  // `cells`: where the points are at shift (0, 0); blocks are counted from `first_shift`.
  ScanAtYaw(const ScorePyramid& pyramid, ScanCells cells, const submap::CellIndex& first_shift);

  // sums[y * side + x]: sum over the points of weight * bound of the level's block
  // (first_block.x + x, first_block.y + y), in steps of 1/255 of 1/64. `side` is 4 or 8.
  void SumBlocks(int level, const submap::CellIndex& first_block, int side, int32_t* sums);

 private:
  struct LevelPoint {
    int x, y;
    int phase_offset;
    int weight;
  };
  struct PlanePoints {
    int plane;
    size_t begin, end;  // in the level's points
  };
  struct LevelPoints {
    std::vector<LevelPoint> points;
    std::vector<PlanePoints> planes;
  };

  const LevelPoints& PointsOf(int level);
  LevelPoints MakePoints(int level) const;
  // Adds the points of a layer at `next`, all of them or with neighbours merged. Returns their end.
  LevelPoint* AddEach(const PyramidLevel& level, int plane, const ScanCells::Layer& layer,
                      LevelPoint* next) const;
  LevelPoint* AddMerged(const PyramidLevel& level, int plane, const ScanCells::Layer& layer,
                        LevelPoint* next) const;
  // The points that a square of blocks may touch, into lookups_. Returns their number.
  size_t LookUp(int level, const submap::CellIndex& first_block);

  const ScorePyramid& pyramid_;
  const ScanCells cells_;
  const submap::CellIndex first_shift_;
  std::vector<LevelPoints> levels_;
  std::vector<Lookup> lookups_;
};

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SCAN_AT_YAW_H_
