// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/pose_graph.h"

#include <cmath>
#include <utility>

#include "cartographer/common/parallel.h"
#include "cartographer/common/status.h"
#include "cartographer/pose_graph/agreement.h"
#include "cartographer/pose_graph/find_candidates.h"
#include "cartographer/pose_graph/optimize_graph.h"
#include "cartographer/pose_graph/verify_closure.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {

using submap::Constraint;
using submap::NodeId;
using submap::PlacedNode;
using submap::Submap;
using submap::SubmapId;

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
      describer_(describer),
      search_(options, model, labels),
      places_(describer) {}

void PoseGraph::AddNode(const NodeId& node_id, PlacedNode node,
                        const std::map<int, std::shared_ptr<const Submap>>& submaps,
                        std::vector<common::StageTime>* stage_times) {
  const bool first = !last_node_.has_value() || last_node_->trajectory_id != node_id.trajectory_id;
  if (!first) {
    const transform::Rigid3d& local_from_last = graph_.nodes.at(*last_node_).local_from_node;
    since_searched_m_ +=
        (node.local_from_node.translation() - local_from_last.translation()).norm();
  }
  node.map_from_node = map_from_local_ * node.local_from_node;
  CHECK(graph_.nodes.emplace(node_id, std::move(node)).second);
  last_node_ = node_id;
  AddSubmaps(node_id, submaps);
  if (!Enabled()) return;

  if (first || since_searched_m_ >= options_.candidates().node_spacing_m()) {
    to_search_.push_back(node_id);
    since_searched_m_ = 0.;
  }
  if (++nodes_since_round_ < options_.optimize_every_n_nodes()) return;
  nodes_since_round_ = 0;
  RunRound(std::exchange(to_search_, {}), stage_times);
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

void PoseGraph::Finish(std::vector<common::StageTime>* stage_times) {
  if (!Enabled() || graph_.nodes.empty()) return;
  RunRound(std::exchange(to_search_, {}), stage_times);
  // Once the loops are closed the windows are small, and nodes that were driven past before their
  // place was known have a chance.
  RunRound(NodesWithoutClosure(), stage_times);
}

void PoseGraph::RunRound(const std::vector<NodeId>& node_ids,
                         std::vector<common::StageTime>* stage_times) {
  common::Stopwatch stopwatch;
  const Topology topology(graph_);
  DescribeFinishedSubmaps(topology);
  const std::vector<ClosureCandidate> candidates =
      FindCandidates(KeepReady(node_ids, topology), topology);
  stopwatch.Lap("closure_candidates", stage_times);
  Book(search_.Search(candidates, graph_));
  const bool any = AcceptAgreed(topology);
  ForgetLonely(topology);
  stopwatch.Lap("closure_search", stage_times);
  if (any) Optimize();
  stopwatch.Lap("optimization", stage_times);
}

std::vector<NodeId> PoseGraph::KeepReady(const std::vector<NodeId>& node_ids,
                                         const Topology& topology) {
  std::vector<NodeId> ready;
  for (const NodeId& id : node_ids) {
    const SubmapId* const own_id = topology.OldestSubmapOf(id);
    if (own_id == nullptr) continue;
    const bool finished = graph_.submaps.at(*own_id).submap->finished;
    (finished ? ready : to_search_).push_back(id);
  }
  searched_.insert(ready.begin(), ready.end());
  return ready;
}

PlaceDescriptor PoseGraph::Describe(const SubmapId& submap_id, const Topology& topology) const {
  const Submap& submap = *graph_.submaps.at(submap_id).submap;
  const PlacedNode& middle = graph_.nodes.at(*topology.MiddleNode(submap_id));
  const transform::Rigid3d submap_from_middle =
      submap.local_from_submap.inverse() * middle.local_from_node;
  return describer_.Describe({{submap.cloud, transform::Rigid3d::Identity()}},
                             submap_from_middle.translation().head<2>());
}

void PoseGraph::DescribeFinishedSubmaps(const Topology& topology) {
  std::vector<SubmapId> ids;
  for (const auto& [id, placed] : graph_.submaps) {
    if (!placed.submap->finished || topology.MiddleNode(id) == nullptr) continue;
    if (described_.insert(id).second) ids.push_back(id);
  }
  std::vector<PlaceDescriptor> descriptors(ids.size());
  common::ParallelChunks(ids.size(), 1,
                         [&](size_t i, size_t) { descriptors[i] = Describe(ids[i], topology); });
  for (size_t i = 0; i < ids.size(); ++i) places_.Add(ids[i], descriptors[i]);
}

std::vector<ClosureCandidate> PoseGraph::FindCandidates(const std::vector<NodeId>& node_ids,
                                                        const Topology& topology) const {
  std::vector<std::vector<ClosureCandidate>> by_node(node_ids.size());
  common::ParallelChunks(node_ids.size(), 1, [&](size_t i, size_t) {
    by_node[i] = CandidatesOf(node_ids[i], topology);
  });
  std::vector<ClosureCandidate> candidates;
  for (const auto& of_node : by_node) {
    candidates.insert(candidates.end(), of_node.begin(), of_node.end());
  }
  return candidates;
}

std::vector<ClosureCandidate> PoseGraph::CandidatesOf(const NodeId& node_id,
                                                      const Topology& topology) const {
  const proto::CandidateOptions& options = options_.candidates();
  const std::vector<OtherVisit> visits =
      FindOtherVisits(node_id, options.min_travel_m(), graph_, topology);
  std::vector<ClosureCandidate> candidates =
      NearbyCandidates(node_id, visits, options, graph_, topology);
  const std::vector<ClosureCandidate> proposed = ProposedCandidates(
      node_id, UncertainVisits(node_id, visits, options, graph_, topology), topology);
  candidates.insert(candidates.end(), proposed.begin(), proposed.end());
  return candidates;
}

std::vector<ClosureCandidate> PoseGraph::ProposedCandidates(const NodeId& node_id,
                                                            const std::vector<SubmapId>& among,
                                                            const Topology& topology) const {
  if (among.empty()) return {};
  // Place recognition compares submaps, which show more than a scan: the node's own stands for it.
  const SubmapId& own_id = *topology.OldestSubmapOf(node_id);
  const scan_matching::PlanarPose own_from_node =
      scan_matching::InPlane(graph_.submaps.at(own_id).submap->local_from_submap.inverse() *
                             transform::Level(graph_.nodes.at(node_id).local_from_node));
  const std::set<SubmapId> allowed(among.begin(), among.end());
  std::vector<ClosureCandidate> candidates;
  for (const PlaceCandidate& place :
       places_.Find(Describe(own_id, topology), options_.candidates().max_places(),
                    [&](const SubmapId& id) { return allowed.count(id) > 0; })) {
    candidates.push_back(CandidateAtPlace(node_id, place, own_from_node, options_.candidates()));
  }
  return candidates;
}

void PoseGraph::Book(const std::vector<SearchedCandidate>& results) {
  for (const SearchedCandidate& result : results) {
    if (result.verdict == VerdictName(Verdict::kAccepted)) {
      waiting_.push_back(result.closure);
    } else {
      ++verdicts_[result.verdict];
    }
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
  closures_.push_back(closure);
  graph_.constraints.push_back(closure.constraint);
  closed_nodes_.insert(closure.constraint.node_id);
  ++verdicts_[std::string(VerdictName(Verdict::kAccepted))];
}

void PoseGraph::ForgetLonely(const Topology& topology) {
  const double driven_m = topology.DrivenTo(*last_node_);
  std::vector<Closure> still_waiting;
  for (const Closure& closure : waiting_) {
    const NodeId& node_id = closure.constraint.node_id;
    if (node_id.trajectory_id == last_node_->trajectory_id &&
        driven_m - topology.DrivenTo(node_id) <= 2. * options_.agreement().max_travel_m()) {
      still_waiting.push_back(closure);
    } else {
      ++verdicts_["no_agreement"];
    }
  }
  waiting_ = std::move(still_waiting);
}

void PoseGraph::Optimize() {
  OptimizeGraph(options_.optimization(), &graph_);
  const PlacedNode& last = graph_.nodes.at(*last_node_);
  map_from_local_ = last.map_from_node * last.local_from_node.inverse();
}

std::vector<NodeId> PoseGraph::NodesWithoutClosure() const {
  std::vector<NodeId> node_ids;
  for (const NodeId& id : searched_) {
    if (closed_nodes_.count(id) == 0) node_ids.push_back(id);
  }
  return node_ids;
}

}  // namespace cartographer::pose_graph
