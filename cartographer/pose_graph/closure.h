// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_CLOSURE_H_
#define CARTOGRAPHER_POSE_GRAPH_CLOSURE_H_

#include <map>
#include <string>

#include "cartographer/submap/constraint.h"

namespace cartographer::pose_graph {

// A loop closure as it was found, for reports.
struct Closure {
  submap::Constraint constraint;
  double score = 0.;    // of the match in the plane, in [0, 1]
  double overlap = 0.;  // verify_closure.h has these
  double inlier_ratio = 0.;
  // How far the closure moves the node relative to the submap, against the map's estimate when it
  // was found.
  double correction_m = 0.;
  double correction_deg = 0.;
  bool by_place_recognition = false;
  // Says nothing of height, roll and pitch.
  bool in_plane = false;
};

// What became of a candidate. `closure` is filled in as far as the candidate came.
struct SearchedCandidate {
  std::string verdict;  // a word of VerdictCounts
  Closure closure;
};

// Candidates by what became of them: "accepted", "no_match", "no_agreement" or a word of
// VerdictName().
using VerdictCounts = std::map<std::string, int>;

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_CLOSURE_H_
