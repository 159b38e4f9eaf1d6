// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/node_search.h"

#include <string>

#include "cartographer/pose_graph/verify_closure.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

int StageReached(const std::string& verdict) {
  if (verdict == "no_match") return 0;
  if (verdict == "no_agreement") return kNumVerdicts;
  for (int i = 1; i < kNumVerdicts; ++i) {
    if (verdict == VerdictName(static_cast<Verdict>(i))) return i;
  }
  LOG(FATAL) << "unknown verdict of a rejected candidate: " << verdict;
}

}  // namespace

void NoteRejected(const SearchedCandidate& candidate, NodeSearch* search) {
  const auto& best = search->best_rejected;
  if (best.has_value()) {
    const int reached = StageReached(candidate.verdict);
    const int best_reached = StageReached(best->verdict);
    if (reached < best_reached) return;
    if (reached == best_reached && candidate.closure.score <= best->closure.score) return;
  }
  search->best_rejected = candidate;
}

}  // namespace cartographer::pose_graph
