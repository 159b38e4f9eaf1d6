// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/branch_and_bound.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "cartographer/common/parallel.h"
#include "cartographer/scan_matching/scan_at_yaw.h"

namespace cartographer::scan_matching {
namespace {

constexpr int kMaxSide = PyramidLevel::kMargin + 1;
// The search begins at the level with the largest blocks of which so many fit side by side.
constexpr int kMinBlocksAcross = 2;
// Before all else the search dives for a good pose at this many headings.
constexpr size_t kDives = 16;
constexpr size_t kYawsPerChunk = 8;

// A square of shifts at some level, counted from the space's first shift in units of its side. At
// level 0 it is a single shift and its bound is its score.
struct Block {
  int32_t bound;
  int x, y;

  // Best bounds first, then in the order of poses.
  bool operator<(const Block& other) const {
    return std::tie(other.bound, y, x) < std::tie(bound, other.y, other.x);
  }
};

struct Problem {
  const ScorePyramid& pyramid;
  const MatchingScan& scan;
  const SearchSpace& space;
  double resolution_m;
  int32_t min_score;
  int top_level;
  SharedScore* shared;

  int log2_window(int level) const { return pyramid.level(level).log2_window(); }
  int32_t Threshold() const { return std::max(min_score, shared->Get()); }

  // The scan's cells at shift (0, 0).
  ScanCells CellsAt(size_t yaw) const {
    return scan.CellsAt(space.PoseAt(yaw, {0, 0}, resolution_m), resolution_m);
  }
};

// The search at one heading.
class YawSearch {
 public:
  YawSearch(const Problem& problem, size_t yaw)
      : problem_(problem),
        scan_(problem.pyramid, problem.CellsAt(yaw), problem.space.first_shift) {}

  // The blocks of the top level that may win, best first.
  std::vector<Block> TopBlocks() {
    const int log2_window = problem_.log2_window(problem_.top_level);
    const submap::CellIndex blocks = (problem_.space.num_shifts - 1).unaryExpr([&](int shifts) {
      return (shifts >> log2_window) + 1;
    });
    const int side = blocks.maxCoeff() <= 4 ? 4 : 8;
    std::vector<Block> result;
    for (int y = 0; y < blocks.y(); y += side) {
      for (int x = 0; x < blocks.x(); x += side) {
        AddBlocks(problem_.top_level, {x, y}, side, side, &result);
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Goes down from a block to a single pose, by the best bound at each level.
  void Dive(int level, const Block& block) {
    if (level == 0) return Take(block);
    const std::vector<Block> children = Children(level, block);
    if (!children.empty()) Dive(level - 1, *std::min_element(children.begin(), children.end()));
  }

  // Searches the block for whatever may win.
  void Search(int level, const Block& block) {
    if (!MayWin(level, block)) return;
    if (level == 0) return Take(block);
    std::vector<Block> children = Children(level, block);
    std::sort(children.begin(), children.end());
    for (const Block& child : children) Search(level - 1, child);
  }

  // The best pose of those that were searched; bound 0 if none would do.
  const Block& best() const { return best_; }

 private:
  std::vector<Block> Children(int level, const Block& block) {
    const int log2_side = problem_.log2_window(level) - problem_.log2_window(level - 1);
    std::vector<Block> children;
    AddBlocks(level - 1, {block.x << log2_side, block.y << log2_side}, std::max(4, 1 << log2_side),
              1 << log2_side, &children);
    return children;
  }

  // Sums a square of `side` blocks and adds the first `used` rows and columns of them.
  void AddBlocks(int level, const submap::CellIndex& first, int side, int used,
                 std::vector<Block>* blocks) {
    std::array<int32_t, kMaxSide * kMaxSide> sums;
    scan_.SumBlocks(level, first, side, sums.data());
    const int log2_window = problem_.log2_window(level);
    const submap::CellIndex last = (problem_.space.num_shifts - 1).unaryExpr([&](int shifts) {
      return shifts >> log2_window;
    });
    const int columns = std::min(used, last.x() - first.x() + 1);
    const int rows = std::min(used, last.y() - first.y() + 1);
    const int32_t threshold = problem_.Threshold();
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const int32_t bound = sums[y * side + x];
        if (bound >= threshold) blocks->push_back({bound, first.x() + x, first.y() + y});
      }
    }
  }

  // Whether the block can have a pose that others at this or another heading don't beat.
  bool MayWin(int level, const Block& block) const {
    if (block.bound < problem_.Threshold() || block.bound < best_.bound) return false;
    const int log2_window = problem_.log2_window(level);
    return block.bound > best_.bound ||
           Block{block.bound, block.x << log2_window, block.y << log2_window} < best_;
  }

  void Take(const Block& pose) {
    if (pose.bound < problem_.min_score || !(pose < best_)) return;
    best_ = pose;
    problem_.shared->Raise(pose.bound);
  }

  const Problem& problem_;
  ScanAtYaw scan_;
  Block best_{0, 0, 0};
};

// The headings at which something may win, those with the best bound first.
std::vector<std::pair<size_t, std::vector<Block>>> PromisingYaws(const Problem& problem) {
  std::vector<std::vector<Block>> blocks(problem.space.yaws_rad.size());
  common::ParallelChunks(blocks.size(), kYawsPerChunk, [&](size_t begin, size_t end) {
    for (size_t yaw = begin; yaw < end; ++yaw) blocks[yaw] = YawSearch(problem, yaw).TopBlocks();
  });
  std::vector<std::pair<size_t, std::vector<Block>>> result;
  for (size_t yaw = 0; yaw < blocks.size(); ++yaw) {
    if (!blocks[yaw].empty()) result.emplace_back(yaw, std::move(blocks[yaw]));
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return a.second.front().bound > b.second.front().bound;
  });
  return result;
}

}  // namespace

std::optional<BestPose> FindBestPose(const ScorePyramid& pyramid, const MatchingScan& scan,
                                     const SearchSpace& space, double resolution_m,
                                     int32_t min_score, SharedScore* shared) {
  if (scan.empty() || (space.num_shifts <= 0).any()) return std::nullopt;
  SharedScore own;
  int top_level = pyramid.num_levels() - 1;
  while (top_level > 0 &&
         space.num_shifts.maxCoeff() < kMinBlocksAcross << pyramid.level(top_level).log2_window()) {
    --top_level;
  }
  const Problem problem{pyramid,
                        scan,
                        space,
                        resolution_m,
                        std::max(min_score, 1),
                        top_level,
                        shared != nullptr ? shared : &own};
  const auto yaws = PromisingYaws(problem);
  common::ParallelChunks(std::min(kDives, yaws.size()), 1, [&](size_t i, size_t) {
    YawSearch(problem, yaws[i].first).Dive(top_level, yaws[i].second.front());
  });
  // Whichever thread is free takes the best heading that is left.
  std::vector<Block> best(yaws.size(), Block{0, 0, 0});
  std::atomic<size_t> next{0};
  common::ParallelChunks(yaws.size(), 1, [&](size_t, size_t) {
    const size_t i = next.fetch_add(1);
    if (yaws[i].second.front().bound < problem.Threshold()) return;
    YawSearch search(problem, yaws[i].first);
    for (const Block& block : yaws[i].second) search.Search(top_level, block);
    best[i] = search.best();
  });
  std::optional<BestPose> winner;
  for (size_t i = 0; i < yaws.size(); ++i) {
    const auto& [score, x, y] = best[i];
    const size_t yaw = yaws[i].first;
    if (score == 0) continue;
    if (!winner.has_value() || score > winner->score ||
        (score == winner->score && yaw < winner->yaw)) {
      winner = BestPose{score, yaw, space.first_shift + submap::CellIndex(x, y)};
    }
  }
  return winner;
}

}  // namespace cartographer::scan_matching
