// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/node_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace cartographer::pose_graph {
namespace {

SearchedCandidate Candidate(const char* verdict, double score) {
  SearchedCandidate candidate;
  candidate.verdict = verdict;
  candidate.closure.score = score;
  return candidate;
}

// From the one that came least far to the one that came furthest.
std::vector<SearchedCandidate> Ascending() {
  return {Candidate("no_match", 0.),      Candidate("icp_failed", 0.9),
          Candidate("low_overlap", 0.4),  Candidate("low_overlap", 0.6),
          Candidate("degenerate", 0.3),   Candidate("no_agreement", 0.2),
          Candidate("no_agreement", 0.25)};
}

TEST(NodeSearchTest, KeepsTheCandidateThatCameFurthestWhateverTheOrder) {
  std::vector<int> order = {0, 1, 2, 3, 4, 5, 6};
  do {
    NodeSearch search;
    size_t furthest = 0;
    for (const int i : order) {
      NoteRejected(Ascending()[i], &search);
      furthest = std::max<size_t>(furthest, i);
      ASSERT_EQ(search.best_rejected->verdict, Ascending()[furthest].verdict);
      ASSERT_EQ(search.best_rejected->closure.score, Ascending()[furthest].closure.score);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(NodeSearchTest, TheFirstOfEqualOnesStays) {
  NodeSearch search;
  for (const int submap : {3, 5}) {
    SearchedCandidate candidate = Candidate("large_error", 0.5);
    candidate.closure.constraint.submap_id = {0, submap};
    NoteRejected(candidate, &search);
  }
  EXPECT_EQ(search.best_rejected->closure.constraint.submap_id.submap_index, 3);
}

TEST(NodeSearchDeathTest, VerdictsMustBeKnown) {
  NodeSearch search;
  NoteRejected(Candidate("no_match", 0.), &search);
  EXPECT_DEATH(NoteRejected(Candidate("accepted", 0.5), &search), "unknown verdict");
}

}  // namespace
}  // namespace cartographer::pose_graph
