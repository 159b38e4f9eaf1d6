// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_POSE_GRAPH_H_
#define CARTOGRAPHER_POSE_GRAPH_POSE_GRAPH_H_

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/pose_graph/candidate_finder.h"
#include "cartographer/pose_graph/closure.h"
#include "cartographer/pose_graph/closure_search.h"
#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/node_search.h"
#include "cartographer/pose_graph/optimize_graph.h"
#include "cartographer/pose_graph/proto/pose_graph_options.pb.h"
#include "cartographer/pose_graph/topology.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::pose_graph {

// What the last look for a node's place came to: "accepted" (verified; whether others agree is
// another question), "no_candidate", or the verdict of the candidate that came furthest.
struct NodeOutcome {
  submap::NodeId node_id;
  std::string verdict;
  // Whether it was looked for by what its place looks like, not only near its estimate.
  bool by_place = false;
};

// The back end: takes the nodes and submaps of an odometry, finds where places are seen again, and
// keeps all poses in agreement. Synchronous and deterministic: every optimize_every_n_nodes nodes
// a round of search and optimization runs within AddNode(), in parallel inside; its results do not
// depend on the number of threads.
//
// It may begin with a finished map, frozen or not, to which the drive is then tied. Until the first
// closure does so, the drive is wherever its local frame puts it.
class PoseGraph {
 public:
  // Errors name the option: score groups that the label set does not fit.
  static absl::StatusOr<std::unique_ptr<PoseGraph>> Create(const proto::PoseGraphOptions& options,
                                                           const sensor::LabelSet& labels);

  // Adds trajectories that are finished. None may be there yet (CHECKed).
  void AddMap(const Graph& map);

  // A node as the odometry has it; `map_from_node` is ignored: the node is put where the last
  // optimization wants it.
  //   submaps    those that took the node's scan, by their index within the trajectory
  // Nodes of a trajectory come in order, submaps may still grow and are searched as soon as they
  // are finished. What the round took, if one was due, is appended to `stage_times`.
  void AddNode(const submap::NodeId& node_id, submap::PlacedNode node,
               const std::map<int, std::shared_ptr<const submap::Submap>>& submaps,
               std::vector<common::StageTime>* stage_times);

  // The trajectory that is about to begin starts near map_from_local, known about as well as after
  // `path_m` of driving (SearchWindowOptions).
  void ExpectNear(int trajectory_id, const transform::Rigid3d& map_from_local, double path_m);

  // The last rounds, when all submaps are finished: with everything known, places that could not be
  // found before are looked for once more.
  void Finish(std::vector<common::StageTime>* stage_times);

  // Looks for the nodes of trajectories that came by AddMap() in all others, and optimizes.
  void SearchTrajectories(const std::set<int>& trajectory_ids,
                          std::vector<common::StageTime>* stage_times);

  // Bounded memory: removes what is before a node of its trajectory, or all of a trajectory, with
  // the closures there.
  void TrimBefore(const submap::NodeId& first_kept);
  void RemoveTrajectory(int trajectory_id);

  const Graph& graph() const { return graph_; }
  // Hands out the graph. No other call may follow.
  Graph Release() { return std::move(graph_); }

  // Of the trajectory that grows.
  const transform::Rigid3d& map_from_local() const { return map_from_local_; }
  // Whether closures tie a trajectory to any other.
  bool IsTied(int trajectory_id) const;

  // Accepted ones, in the order in which they were.
  const std::vector<Closure>& closures() const { return closures_; }
  const VerdictCounts& verdicts() const { return verdicts_; }
  // All nodes that were looked for, with what came of it in all rounds: an entry each, however many
  // candidates there were.
  const std::map<submap::NodeId, NodeSearch>& searches() const { return searches_; }
  // Those of the last round; empty if none was run by the last AddNode().
  const std::vector<NodeOutcome>& last_outcomes() const { return last_outcomes_; }
  // How the last optimization went; of no loops before the first.
  const OptimizationReport& last_optimization() const { return last_optimization_; }

 private:
  using Nodes = std::vector<submap::NodeId>;

  PoseGraph(const proto::PoseGraphOptions& options, const scan_matching::ScoreModel& model,
            const sensor::LabelSet& labels, const PlaceDescriber& describer);

  bool Enabled() const { return options_.optimize_every_n_nodes() > 0; }
  void AddSubmaps(const submap::NodeId& node_id,
                  const std::map<int, std::shared_ptr<const submap::Submap>>& submaps);
  // Those of to_recognize_ whose submaps are finished; the others stay.
  Nodes TakeRecognizable();
  Nodes SpacedNodes(const std::set<int>& trajectory_ids) const;
  Nodes NodesWithoutClosure() const;

  // Searches near some nodes and for the places of some.
  void RunRound(const Nodes& nearby, const Nodes& recognizable,
                std::vector<common::StageTime>* stage_times);
  // Steps of a round.
  // A pair of node and submap is searched until it is verified, not again.
  void DropVerified(std::vector<ClosureCandidate>* candidates);
  void SearchEverywhere(const Nodes& recognizable, const Topology& topology);
  void Book(const std::vector<SearchedCandidate>& results);
  void NoteOutcomes(const Nodes& nearby, const Nodes& recognizable);
  // Accepts what enough neighbours agree with. Returns whether there was any.
  bool AcceptAgreed(const Topology& topology);
  void Accept(const Closure& closure);
  void ForgetLonely(const Topology& topology);
  void Reject(const SearchedCandidate& candidate);
  void Optimize();
  // Forgets what is about nodes or submaps that are not in the graph.
  void Prune();

  const proto::PoseGraphOptions options_;
  Graph graph_;
  ClosureSearch search_;
  CandidateFinder finder_;

  // Of the trajectory that grows.
  transform::Rigid3d map_from_local_;
  std::optional<submap::NodeId> last_node_;
  double since_searched_m_ = 0.;
  int nodes_since_round_ = 0;
  int not_recognized_ = 0;                                   // in a row
  Nodes to_search_;                                          // since the last round
  std::map<submap::NodeId, submap::SubmapId> to_recognize_;  // with their oldest submaps
  std::map<submap::NodeId, NodeSearch> searches_;            // all
  std::set<submap::NodeId> closed_nodes_;

  std::set<std::pair<submap::NodeId, submap::SubmapId>> verified_;  // of waiting_ and closures_
  std::vector<Closure> waiting_;  // verified, but nothing near them agrees yet
  std::vector<Closure> closures_;
  VerdictCounts verdicts_;
  std::map<submap::NodeId, std::string> outcome_of_node_;  // of the round that runs
  std::vector<NodeOutcome> last_outcomes_;
  OptimizationReport last_optimization_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_POSE_GRAPH_H_
