// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/pose_graph.h"

#include <algorithm>
#include <utility>

#include "cartographer/common/status.h"
#include "cartographer/pose_graph/agreement.h"
#include "cartographer/pose_graph/erase_keys.h"
#include "cartographer/pose_graph/join_groups.h"
#include "cartographer/pose_graph/trim.h"
#include "cartographer/pose_graph/verify_closure.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {

using submap::Constraint;
using submap::NodeId;
using submap::PlacedNode;
using submap::Submap;
using submap::SubmapId;

namespace {

template <typename Container, typename Predicate>
void RemoveIf(Container* container, const Predicate& predicate) {
  container->erase(std::remove_if(container->begin(), container->end(), predicate),
                   container->end());
}

std::pair<NodeId, SubmapId> PairOf(const Closure& closure) {
  return {closure.constraint.node_id, closure.constraint.submap_id};
}

double Distance_m(const PlacedNode& a, const PlacedNode& b) {
  return (a.local_from_node.translation() - b.local_from_node.translation()).norm();
}

}  // namespace

absl::StatusOr<std::unique_ptr<PoseGraph>> PoseGraph::Create(const proto::PoseGraphOptions& options,
                                                             const sensor::LabelSet& labels) {
  absl::StatusOr<scan_matching::ScoreModel> model =
      scan_matching::ScoreModel::Create(options.scan_matching().score(), labels);
  RETURN_IF_ERROR(common::AddContext(model.status(), "pose_graph.scan_matching.score"));
  absl::StatusOr<PlaceDescriber> describer =
      PlaceDescriber::Create(options.place_recognition(), labels);
  RETURN_IF_ERROR(common::AddContext(describer.status(), "pose_graph.place_recognition"));
  return std::unique_ptr<PoseGraph>(new PoseGraph(options, *model, labels, *describer));
}

PoseGraph::PoseGraph(const proto::PoseGraphOptions& options, const scan_matching::ScoreModel& model,
                     const sensor::LabelSet& labels, const PlaceDescriber& describer)
    : options_(options),
      search_(options, model, labels),
      finder_(options.candidates(), describer) {}

void PoseGraph::AddMap(const Graph& map) {
  for (const auto& [id, submap] : map.submaps) CHECK(graph_.submaps.emplace(id, submap).second);
  for (const auto& [id, node] : map.nodes) CHECK(graph_.nodes.emplace(id, node).second);
  graph_.constraints.insert(graph_.constraints.end(), map.constraints.begin(),
                            map.constraints.end());
  graph_.frozen_trajectories.insert(map.frozen_trajectories.begin(), map.frozen_trajectories.end());
}

void PoseGraph::ExpectNear(int trajectory_id, const transform::Rigid3d& map_from_local,
                           double path_m) {
  map_from_local_ = map_from_local;
  finder_.ExpectNear(trajectory_id, path_m);
}

void PoseGraph::AddNode(const NodeId& node_id, PlacedNode node,
                        const std::map<int, std::shared_ptr<const Submap>>& submaps,
                        std::vector<common::StageTime>* stage_times) {
  const bool first = !last_node_.has_value() || last_node_->trajectory_id != node_id.trajectory_id;
  if (!first) since_searched_m_ += Distance_m(graph_.nodes.at(*last_node_), node);
  node.map_from_node = map_from_local_ * node.local_from_node;
  CHECK(graph_.nodes.emplace(node_id, std::move(node)).second);
  last_node_ = node_id;
  AddSubmaps(node_id, submaps);
  last_outcomes_.clear();
  if (!Enabled()) return;

  if (first || since_searched_m_ >= options_.candidates().node_spacing_m()) {
    to_search_.push_back(node_id);
    if (!submaps.empty()) {
      to_recognize_[node_id] = {node_id.trajectory_id, submaps.begin()->first};
    }
    since_searched_m_ = 0.;
  }
  if (++nodes_since_round_ < options_.optimize_every_n_nodes()) return;
  nodes_since_round_ = 0;
  RunRound(std::exchange(to_search_, {}), TakeRecognizable(), stage_times);
}

void PoseGraph::AddSubmaps(const NodeId& node_id,
                           const std::map<int, std::shared_ptr<const Submap>>& submaps) {
  for (const auto& [index, submap] : submaps) {
    const SubmapId submap_id{node_id.trajectory_id, index};
    graph_.submaps.emplace(
        submap_id, submap::PlacedSubmap{map_from_local_ * submap->local_from_submap, submap});
    Constraint constraint;
    constraint.submap_id = submap_id;
    constraint.node_id = node_id;
    constraint.submap_from_node =
        submap->local_from_submap.inverse() * graph_.nodes.at(node_id).local_from_node;
    constraint.kind = Constraint::Kind::kIntraSubmap;
    graph_.constraints.push_back(constraint);
  }
}

PoseGraph::Nodes PoseGraph::TakeRecognizable() {
  Nodes recognizable;
  for (auto it = to_recognize_.begin(); it != to_recognize_.end();) {
    if (!graph_.submaps.at(it->second).submap->finished) {
      ++it;
      continue;
    }
    recognizable.push_back(it->first);
    it = to_recognize_.erase(it);
  }
  return recognizable;
}

void PoseGraph::Finish(std::vector<common::StageTime>* stage_times) {
  if (!Enabled() || graph_.nodes.empty()) return;
  RunRound(std::exchange(to_search_, {}), TakeRecognizable(), stage_times);
  // Once the loops are closed the windows are small, and nodes that were driven past before their
  // place was known have a chance.
  const Nodes left = NodesWithoutClosure();
  RunRound(left, left, stage_times);
  // Nothing comes that could still agree.
  for (const Closure& closure : std::exchange(waiting_, {})) Reject({"no_agreement", closure});
}

PoseGraph::Nodes PoseGraph::SpacedNodes(const std::set<int>& trajectory_ids) const {
  Nodes spaced;
  const PlacedNode* last = nullptr;
  double driven_m = 0.;
  for (const auto& [id, node] : graph_.nodes) {
    if (trajectory_ids.count(id.trajectory_id) == 0) continue;
    const bool first = spaced.empty() || spaced.back().trajectory_id != id.trajectory_id;
    if (!first) driven_m += Distance_m(*last, node);
    last = &node;
    if (!first && driven_m < options_.candidates().node_spacing_m()) continue;
    spaced.push_back(id);
    driven_m = 0.;
  }
  return spaced;
}

void PoseGraph::SearchTrajectories(const std::set<int>& trajectory_ids,
                                   std::vector<common::StageTime>* stage_times) {
  const Topology topology(graph_);
  Nodes nodes = SpacedNodes(trajectory_ids);
  RemoveIf(&nodes, [&](const NodeId& id) { return topology.OldestSubmapOf(id) == nullptr; });
  finder_.Settle(trajectory_ids);
  RunRound(nodes, nodes, stage_times);
  const Nodes left = NodesWithoutClosure();
  RunRound(left, left, stage_times);
  // Nothing comes that could still agree.
  for (const Closure& closure : std::exchange(waiting_, {})) Reject({"no_agreement", closure});
}

void PoseGraph::RunRound(const Nodes& nearby, const Nodes& recognizable,
                         std::vector<common::StageTime>* stage_times) {
  if (nearby.empty() && recognizable.empty()) return;
  common::Stopwatch stopwatch;
  outcome_of_node_.clear();
  const Topology topology(graph_);
  finder_.Describe(graph_, topology);
  std::vector<ClosureCandidate> candidates = finder_.Nearby(nearby, graph_, topology);
  const std::vector<ClosureCandidate> places = finder_.ByPlace(recognizable, graph_, topology);
  candidates.insert(candidates.end(), places.begin(), places.end());
  DropVerified(&candidates);
  stopwatch.Lap("closure_candidates", stage_times);
  Book(search_.Search(candidates, graph_));
  SearchEverywhere(recognizable, topology);
  NoteOutcomes(nearby, recognizable);
  const bool any = AcceptAgreed(topology);
  ForgetLonely(topology);
  stopwatch.Lap("closure_search", stage_times);
  if (any) Optimize();
  stopwatch.Lap("optimization", stage_times);
}

void PoseGraph::DropVerified(std::vector<ClosureCandidate>* candidates) {
  RemoveIf(candidates, [this](const ClosureCandidate& candidate) {
    if (verified_.count({candidate.node_id, candidate.submap_id}) == 0) return false;
    outcome_of_node_[candidate.node_id] = std::string(VerdictName(Verdict::kAccepted));
    return true;
  });
}

void PoseGraph::SearchEverywhere(const Nodes& recognizable, const Topology& topology) {
  const int patience = options_.candidates().search_all().after_nodes();
  if (patience == 0) return;
  for (const NodeId& node_id : recognizable) {
    const auto outcome = outcome_of_node_.find(node_id);
    const bool found =
        outcome != outcome_of_node_.end() && outcome->second == VerdictName(Verdict::kAccepted);
    not_recognized_ = found ? 0 : not_recognized_ + 1;
    if (not_recognized_ < patience || IsTied(node_id.trajectory_id)) continue;
    not_recognized_ = 0;
    const auto candidate = search_.FindBest(finder_.Everywhere(node_id, graph_, topology),
                                            *topology.OldestSubmapOf(node_id), graph_);
    if (candidate.has_value()) Book(search_.Search({*candidate}, graph_));
  }
}

void PoseGraph::Book(const std::vector<SearchedCandidate>& results) {
  for (const SearchedCandidate& result : results) {
    std::string& outcome = outcome_of_node_[result.closure.constraint.node_id];
    const bool accepted = result.verdict == VerdictName(Verdict::kAccepted);
    // Found nearby and recognized as well: the same answer twice is no more certain.
    if (accepted && !verified_.insert(PairOf(result.closure)).second) continue;
    if (accepted || outcome.empty() || outcome == "no_match") outcome = result.verdict;
    ++searches_[result.closure.constraint.node_id].num_candidates;
    if (accepted) {
      waiting_.push_back(result.closure);
    } else {
      Reject(result);
    }
  }
}

void PoseGraph::Reject(const SearchedCandidate& candidate) {
  ++verdicts_[candidate.verdict];
  NoteRejected(candidate, &searches_[candidate.closure.constraint.node_id]);
}

void PoseGraph::NoteOutcomes(const Nodes& nearby, const Nodes& recognizable) {
  std::set<NodeId> all(nearby.begin(), nearby.end());
  all.insert(recognizable.begin(), recognizable.end());
  for (const NodeId& id : all) searches_.try_emplace(id);
  const std::set<NodeId> by_place(recognizable.begin(), recognizable.end());
  last_outcomes_.clear();
  for (const NodeId& id : all) {
    const auto outcome = outcome_of_node_.find(id);
    last_outcomes_.push_back({id,
                              outcome == outcome_of_node_.end() ? "no_candidate" : outcome->second,
                              by_place.count(id) > 0});
  }
}

bool PoseGraph::AcceptAgreed(const Topology& topology) {
  std::vector<Closure> all = waiting_;
  all.insert(all.end(), closures_.begin(), closures_.end());
  const std::vector<int> agreeing =
      CountAgreeing(all, waiting_.size(), graph_, topology, options_.agreement());
  std::vector<Closure> still_waiting;
  for (size_t i = 0; i < waiting_.size(); ++i) {
    if (agreeing[i] >= options_.agreement().min_agreeing()) {
      Accept(waiting_[i]);
    } else {
      still_waiting.push_back(waiting_[i]);
    }
  }
  const bool any = still_waiting.size() < waiting_.size();
  waiting_ = std::move(still_waiting);
  return any;
}

void PoseGraph::Accept(const Closure& closure) {
  JoinGroups(closure.constraint, &graph_);
  closures_.push_back(closure);
  graph_.constraints.push_back(closure.constraint);
  closed_nodes_.insert(closure.constraint.node_id);
  ++verdicts_[std::string(VerdictName(Verdict::kAccepted))];
  ++searches_[closure.constraint.node_id].num_accepted;
}

void PoseGraph::ForgetLonely(const Topology& topology) {
  if (!last_node_.has_value()) return;
  const double driven_m = topology.DrivenTo(*last_node_);
  std::vector<Closure> still_waiting;
  for (const Closure& closure : waiting_) {
    const NodeId& node_id = closure.constraint.node_id;
    if (node_id.trajectory_id == last_node_->trajectory_id &&
        driven_m - topology.DrivenTo(node_id) <= 2. * options_.agreement().max_travel_m()) {
      still_waiting.push_back(closure);
    } else {
      verified_.erase(PairOf(closure));
      Reject({"no_agreement", closure});
    }
  }
  waiting_ = std::move(still_waiting);
}

void PoseGraph::Optimize() {
  last_optimization_ = OptimizeGraph(options_.optimization(), &graph_);
  if (!last_node_.has_value()) return;
  const PlacedNode& last = graph_.nodes.at(*last_node_);
  map_from_local_ = last.map_from_node * last.local_from_node.inverse();
}

PoseGraph::Nodes PoseGraph::NodesWithoutClosure() const {
  Nodes node_ids;
  for (const auto& [id, search] : searches_) {
    if (closed_nodes_.count(id) == 0) node_ids.push_back(id);
  }
  return node_ids;
}

bool PoseGraph::IsTied(int trajectory_id) const {
  return std::any_of(graph_.constraints.begin(), graph_.constraints.end(),
                     [=](const Constraint& constraint) {
                       const bool has_node = constraint.node_id.trajectory_id == trajectory_id;
                       const bool has_submap = constraint.submap_id.trajectory_id == trajectory_id;
                       return has_node != has_submap;
                     });
}

void PoseGraph::TrimBefore(const NodeId& first_kept) {
  pose_graph::TrimBefore(first_kept, &graph_);
  Prune();
}

void PoseGraph::RemoveTrajectory(int trajectory_id) {
  pose_graph::RemoveTrajectory(trajectory_id, &graph_);
  if (last_node_.has_value() && last_node_->trajectory_id == trajectory_id) {
    last_node_.reset();
    map_from_local_ = transform::Rigid3d::Identity();
    not_recognized_ = 0;
  }
  Prune();
}

void PoseGraph::Prune() {
  const auto gone = [this](const NodeId& id) { return graph_.nodes.count(id) == 0; };
  const auto dangles = [&](const Closure& closure) {
    return gone(closure.constraint.node_id) ||
           graph_.submaps.count(closure.constraint.submap_id) == 0;
  };
  RemoveIf(&waiting_, dangles);
  RemoveIf(&closures_, dangles);
  verified_.clear();
  for (const Closure& closure : waiting_) verified_.insert(PairOf(closure));
  for (const Closure& closure : closures_) verified_.insert(PairOf(closure));
  RemoveIf(&to_search_, gone);
  for (auto it = closed_nodes_.begin(); it != closed_nodes_.end();) {
    it = gone(*it) ? closed_nodes_.erase(it) : std::next(it);
  }
  EraseKeysIf(&searches_, gone);
  EraseKeysIf(&to_recognize_, gone);
  finder_.Forget(graph_);
}

}  // namespace cartographer::pose_graph
