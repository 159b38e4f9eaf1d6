// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SUBMAP_MATCHER_H_
#define CARTOGRAPHER_SCAN_MATCHING_SUBMAP_MATCHER_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "cartographer/scan_matching/branch_and_bound.h"
#include "cartographer/scan_matching/matching_scan.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/scan_matching/score_pyramid.h"
#include "cartographer/scan_matching/search_space.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::scan_matching {

struct Match {
  PlanarPose submap_from_node;
  double score;  // in [0, 1]; score_model.h has the formula
};

// Finds where in a submap scans were taken. Immutable; may be used by several threads. Scans must
// be made with the same ScoreModel.
class SubmapMatcher {
 public:
  // Precomputes, with one thread; the grid is not needed afterwards.
  SubmapMatcher(const submap::SemanticGrid& grid, const ScoreModel& model);

  // The best of the poses around a guess that score at least `min_score`; nullopt if none does, if
  // the scan is empty or nothing agrees. Ties: SearchSpace; `shared`: FindBestPose().
  std::optional<Match> MatchInWindow(const MatchingScan& scan, const PlanarPose& guess,
                                     const SearchWindow& window, double min_score,
                                     SharedScore* shared = nullptr) const;

  // The same for all headings and all positions of the node within the box of the submap's hits.
  std::optional<Match> MatchInWholeSubmap(const MatchingScan& scan, double min_score,
                                          SharedScore* shared = nullptr) const;

  // The score at a pose, in [0, 1]; 0 for an empty scan. Where a match was found it is the match's
  // score, but for points that lie on a cell's border to within round-off.
  double ScoreAt(const MatchingScan& scan, const PlanarPose& submap_from_node) const;

  const ScorePyramid& pyramid() const { return pyramid_; }
  // The side of the grid's cells.
  double resolution_m() const { return resolution_m_; }
  size_t num_bytes() const { return sizeof(*this) + pyramid_.num_bytes(); }

 private:
  std::optional<Match> Find(const MatchingScan& scan, const SearchSpace& space, double min_score,
                            SharedScore* shared) const;

  double resolution_m_;
  submap::SemanticGrid::CellBox box_;
  ScorePyramid pyramid_;
};

// A submap to search, and where in it.
struct SearchArea {
  std::shared_ptr<const SubmapMatcher> matcher;
  struct Around {
    PlanarPose guess;
    SearchWindow window;
  };
  std::optional<Around> around;  // nullopt: all of it
};

// The best match of a scan in any of several areas.
struct MatchInAreas {
  size_t index;  // of the area
  Match match;
};

// The highest score wins, the first area on ties; nullopt if none has a pose that scores at least
// `min_score`. Areas are searched in parallel and share the best score as their bound: once the
// right one is found the others are soon done.
std::optional<MatchInAreas> MatchInAny(const std::vector<SearchArea>& areas,
                                       const MatchingScan& scan, double min_score);

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SUBMAP_MATCHER_H_
