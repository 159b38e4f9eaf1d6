// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_NODE_SEARCH_H_
#define CARTOGRAPHER_POSE_GRAPH_NODE_SEARCH_H_

#include <optional>

#include "cartographer/pose_graph/closure.h"

namespace cartographer::pose_graph {

// What came of looking for the place of one node, for reports.
struct NodeSearch {
  int num_candidates = 0;
  int num_accepted = 0;
  // Of the candidates that became no closure, the one that came furthest: in the order no_match,
  // the verdicts in their order, no_agreement; of several the one with the best score, then the
  // first.
  std::optional<SearchedCandidate> best_rejected;
};

// Keeps the candidate if it is the best rejected one so far. CHECK-fails on an unknown verdict.
void NoteRejected(const SearchedCandidate& candidate, NodeSearch* search);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_NODE_SEARCH_H_
