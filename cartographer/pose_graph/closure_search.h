// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_CLOSURE_SEARCH_H_
#define CARTOGRAPHER_POSE_GRAPH_CLOSURE_SEARCH_H_

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cartographer/pose_graph/closure.h"
#include "cartographer/pose_graph/closure_target.h"
#include "cartographer/pose_graph/find_candidates.h"
#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/proto/pose_graph_options.pb.h"
#include "cartographer/scan_matching/matcher_cache.h"
#include "cartographer/scan_matching/matching_scan.h"
#include "cartographer/scan_matching/refine_in_plane.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::pose_graph {

// Looks where candidates say and judges what is found: branch and bound in the submap's grid, then,
// as the options say, registration and verification in space.
class ClosureSearch {
 public:
  ClosureSearch(const proto::PoseGraphOptions& options, const scan_matching::ScoreModel& model,
                const sensor::LabelSet& labels);

  // One result for each candidate, in their order. Parallel; the results do not depend on the
  // number of threads, nor on what was searched before.
  std::vector<SearchedCandidate> Search(const std::vector<ClosureCandidate>& candidates,
                                        const Graph& graph);

  // Of candidates for one node, the place where most of what its own finished submap shows agrees,
  // as a candidate with a small window; nullopt if that scores less than the options of the search
  // of all submaps want. The candidates share the best score so far as their bound.
  std::optional<ClosureCandidate> FindBest(const std::vector<ClosureCandidate>& candidates,
                                           const submap::SubmapId& own_submap_id,
                                           const Graph& graph);

  // Forgets what was kept of a submap that is gone.
  void Forget(const submap::SubmapId& submap_id) { matchers_.Remove(submap_id); }

 private:
  using Scans = std::map<submap::NodeId, std::shared_ptr<const scan_matching::MatchingScan>>;
  using Targets = std::map<submap::SubmapId, std::shared_ptr<const ClosureTarget>>;

  // Appends to the results.
  void SearchSome(const std::vector<ClosureCandidate>& candidates, const Graph& graph,
                  std::vector<SearchedCandidate>* results);
  Scans MakeScans(const std::vector<ClosureCandidate>& candidates, const Graph& graph) const;
  Targets MakeTargets(const std::vector<ClosureCandidate>& candidates, const Graph& graph) const;
  std::shared_ptr<const ClosureTarget> MakeTarget(const submap::SubmapId& submap_id,
                                                  const Graph& graph) const;
  // `target` is only used in space.
  SearchedCandidate SearchOne(const ClosureCandidate& candidate,
                              const scan_matching::MatchingScan& scan, const ClosureTarget* target,
                              bool tied, const Graph& graph);
  void VerifyInPlane(const scan_matching::PlanarRefinement& refined, const Graph& graph,
                     Closure* closure) const;

  const proto::PoseGraphOptions options_;
  const bool verify_in_plane_;
  const scan_matching::ScoreModel model_;
  const sensor::LabelSet labels_;
  scan_matching::MatcherCache matchers_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_CLOSURE_SEARCH_H_
