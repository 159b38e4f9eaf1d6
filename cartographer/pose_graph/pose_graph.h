// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_POSE_GRAPH_H_
#define CARTOGRAPHER_POSE_GRAPH_POSE_GRAPH_H_

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/pose_graph/closure.h"
#include "cartographer/pose_graph/closure_search.h"
#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/place_index.h"
#include "cartographer/pose_graph/proto/pose_graph_options.pb.h"
#include "cartographer/pose_graph/topology.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::pose_graph {

// The back end: takes the nodes and submaps of an odometry, finds where places are seen again, and
// keeps all poses in agreement. Synchronous and deterministic: every optimize_every_n_nodes nodes
// a round of search and optimization runs within AddNode(), in parallel inside; its results do not
// depend on the number of threads.
class PoseGraph {
 public:
  // Errors name the option: score groups that the label set does not fit.
  static absl::StatusOr<std::unique_ptr<PoseGraph>> Create(const proto::PoseGraphOptions& options,
                                                           const sensor::LabelSet& labels);

  // A node as the odometry has it; `map_from_node` is ignored: the node is put where the last
  // optimization wants it.
  //   submaps    those that took the node's scan, by their index within the trajectory
  // Nodes of a trajectory come in order, submaps may still grow and are searched as soon as they
  // are finished. What the round took, if one was due, is appended to `stage_times`.
  void AddNode(const submap::NodeId& node_id, submap::PlacedNode node,
               const std::map<int, std::shared_ptr<const submap::Submap>>& submaps,
               std::vector<common::StageTime>* stage_times);

  // The last rounds, when all submaps are finished: with everything known, places that could not be
  // found before are looked for once more.
  void Finish(std::vector<common::StageTime>* stage_times);

  const Graph& graph() const { return graph_; }
  // Hands out the graph. No other call may follow.
  Graph Release() { return std::move(graph_); }

  // Accepted ones, in the order in which they were.
  const std::vector<Closure>& closures() const { return closures_; }
  const VerdictCounts& verdicts() const { return verdicts_; }

 private:
  PoseGraph(const proto::PoseGraphOptions& options, const scan_matching::ScoreModel& model,
            const sensor::LabelSet& labels, const PlaceDescriber& describer);

  bool Enabled() const { return options_.optimize_every_n_nodes() > 0; }
  void AddSubmaps(const submap::NodeId& node_id,
                  const std::map<int, std::shared_ptr<const submap::Submap>>& submaps);
  // Searches for the nodes whose submaps are ready; the others are kept for the next round.
  void RunRound(const std::vector<submap::NodeId>& node_ids,
                std::vector<common::StageTime>* stage_times);

  // Steps of a round.
  std::vector<submap::NodeId> KeepReady(const std::vector<submap::NodeId>& node_ids,
                                        const Topology& topology);
  PlaceDescriptor Describe(const submap::SubmapId& submap_id, const Topology& topology) const;
  void DescribeFinishedSubmaps(const Topology& topology);
  std::vector<ClosureCandidate> FindCandidates(const std::vector<submap::NodeId>& node_ids,
                                               const Topology& topology) const;
  std::vector<ClosureCandidate> CandidatesOf(const submap::NodeId& node_id,
                                             const Topology& topology) const;
  std::vector<ClosureCandidate> ProposedCandidates(const submap::NodeId& node_id,
                                                   const std::vector<submap::SubmapId>& among,
                                                   const Topology& topology) const;
  void Book(const std::vector<SearchedCandidate>& results);
  // Accepts what enough neighbours agree with. Returns whether there was any.
  bool AcceptAgreed(const Topology& topology);
  void Accept(const Closure& closure);
  void ForgetLonely(const Topology& topology);
  void Optimize();

  std::vector<submap::NodeId> NodesWithoutClosure() const;

  const proto::PoseGraphOptions options_;
  const PlaceDescriber describer_;
  Graph graph_;
  ClosureSearch search_;
  PlaceIndex places_;
  std::set<submap::SubmapId> described_;

  // Of the trajectory that grows.
  transform::Rigid3d map_from_local_;
  std::optional<submap::NodeId> last_node_;
  double since_searched_m_ = 0.;
  int nodes_since_round_ = 0;
  std::vector<submap::NodeId> to_search_;  // since the last round
  std::set<submap::NodeId> searched_;      // all
  std::set<submap::NodeId> closed_nodes_;

  std::vector<Closure> waiting_;  // verified, but nothing near them agrees yet
  std::vector<Closure> closures_;
  VerdictCounts verdicts_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_POSE_GRAPH_H_
