// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_BRANCH_AND_BOUND_H_
#define CARTOGRAPHER_SCAN_MATCHING_BRANCH_AND_BOUND_H_

#include <atomic>
#include <cstdint>
#include <optional>

#include "cartographer/scan_matching/matching_scan.h"
#include "cartographer/scan_matching/score_pyramid.h"
#include "cartographer/scan_matching/search_space.h"

namespace cartographer::scan_matching {

// The best score found so far, for searches that look for the single best pose together: of one and
// the same scan in many submaps. Whatever cannot reach it is not searched. Safe between threads.
class SharedScore {
 public:
  // In steps of 1/255 of 1/64: comparable between searches for one MatchingScan alone.
  int32_t Get() const { return score_.load(std::memory_order_relaxed); }
  void Raise(int32_t score) {
    int32_t present = Get();
    while (present < score &&
           !score_.compare_exchange_weak(present, score, std::memory_order_relaxed)) {
    }
  }

 private:
  std::atomic<int32_t> score_{0};
};

struct BestPose {
  int32_t score;  // the numerator, in steps of 1/255 of 1/64
  size_t yaw;     // index into the space's yaws
  submap::CellIndex shift;
};

// The best pose of the space, exactly: the one that scoring every pose would find, the first in the
// space's order if several have that score. nullopt if none reaches `min_score` (taken as at least
// 1: a pose at which nothing agrees is none).
//
// `shared` gives and takes the best score, if it is not null. Poses below it may then be missed,
// and whether one of them is reported depends on the course of the other searches; but never is a
// pose missed that reaches the highest score of all searches. So the winner among them, the first
// of equals, does not depend on `shared`.
//
// Source: the scheme of Hess et al., Real-Time Loop Closure in 2D LIDAR SLAM, ICRA 2016: windows of
// maxima as bounds, best ones first. Ours: semantic layers, blocks of up to 64 shifts summed at
// once, a lower bound by diving first, headings in parallel. The result does not depend on the
// number of threads, because only bounds strictly below the best score, or equal ones that come
// later in order at the same heading, are cut.
std::optional<BestPose> FindBestPose(const ScorePyramid& pyramid, const MatchingScan& scan,
                                     const SearchSpace& space, double resolution_m,
                                     int32_t min_score, SharedScore* shared);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_BRANCH_AND_BOUND_H_
