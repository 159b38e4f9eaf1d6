// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/graph_problem.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "cartographer/pose_graph/relative_pose_cost.h"
#include "ceres/normal_prior.h"
#include "ceres/solver.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;
using transform::Matrix6d;
using transform::Rigid3d;
using transform::Twist;

// Segments are kept this short so that the systematic error may be taken to first order in them.
constexpr double kMaxSegment_m = 50.;

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

std::unique_ptr<ceres::Manifold> MakeManifold(int dof) {
  if (dof < 6) return std::make_unique<PlanarPoseManifold>();
  return std::make_unique<PoseManifold>();
}

Matrix6d InformationOf(const Constraint& constraint) {
  if (constraint.information.has_value()) return *constraint.information;
  Twist weights;
  weights.head<3>().setConstant(constraint.translation_weight);
  weights.tail<3>().setConstant(constraint.rotation_weight);
  return weights.cwiseAbs2().asDiagonal();
}

std::vector<int> SelectKeys(const std::vector<NodeId>& ids, const OdometryChain& chain,
                            const std::set<NodeId>& tied) {
  std::vector<int> keys = {0};
  for (int i = 1; i < chain.size(); ++i) {
    const bool is_far = chain.distance_m(i) - chain.distance_m(keys.back()) > kMaxSegment_m;
    if (is_far && i - 1 > keys.back()) keys.push_back(i - 1);
    if (tied.count(ids[i]) > 0 || i + 1 == chain.size()) keys.push_back(i);
  }
  return keys;
}

}  // namespace

GraphProblem::GraphProblem(const proto::OptimizationOptions& options, const Graph& graph,
                           const GraphSelection& selection)
    : options_(options),
      graph_(graph),
      selection_(selection),
      systematic_sigmas_(ToTwist(options.odometry().systematic())),
      manifold_(MakeManifold(options.dof())),
      weights_(selection.loops.size(), 1.),
      problem_(ProblemOptions()) {
  std::set<NodeId> tied;
  for (const Constraint* loop : selection.loops) {
    tied.insert(loop->node_id);
    const auto tie = selection.ties.find(loop->submap_id);
    if (tie != selection.ties.end()) tied.insert(tie->second.node_id);
  }
  for (const int trajectory_id : selection.moving) AddTrajectory(trajectory_id, tied);
  for (size_t i = 0; i < selection.loops.size(); ++i) AddLoop(*selection.loops[i], &weights_[i]);
}

void GraphProblem::AddPose(PoseBlock* block) {
  problem_.AddParameterBlock(block->data(), kPoseBlockSize, manifold_.get());
}

void GraphProblem::AddFixedPose(PoseBlock* block) {
  AddPose(block);
  problem_.SetParameterBlockConstant(block->data());
}

Rigid3d GraphProblem::Reachable(const Rigid3d& a_from_b, const PoseBlock& a,
                                const PoseBlock& b) const {
  if (options_.dof() == 6) return a_from_b;
  const Rigid3d map_from_a = FromBlock(a.data());
  return map_from_a.inverse() * MovedInPlane(FromBlock(b.data()), map_from_a * a_from_b);
}

void GraphProblem::AddTrajectory(int trajectory_id, const std::set<NodeId>& tied) {
  std::vector<NodeId> ids;
  std::vector<Rigid3d> local_from_node;
  for (auto it = graph_.nodes.lower_bound(NodeId{trajectory_id, 0});
       it != graph_.nodes.end() && it->first.trajectory_id == trajectory_id; ++it) {
    ids.push_back(it->first);
    local_from_node.push_back(it->second.local_from_node);
  }
  OdometryChain chain(options_.odometry(), std::move(local_from_node));
  std::vector<int> keys = SelectKeys(ids, chain, tied);
  Trajectory& trajectory =
      trajectories_
          .emplace(trajectory_id, Trajectory{std::move(ids), std::move(chain), std::move(keys), {}})
          .first->second;
  problem_.AddParameterBlock(trajectory.systematic.data(), 6);
  problem_.AddResidualBlock(
      new ceres::NormalPrior(ceres::Matrix::Identity(6, 6), ceres::Vector::Zero(6)), nullptr,
      trajectory.systematic.data());
  for (const int key : trajectory.keys) {
    const NodeId& id = trajectory.ids[key];
    trajectory.blocks.push_back(ToBlock(graph_.nodes.at(id).map_from_node));
    PoseBlock* const block = &trajectory.blocks.back();
    nodes_[id] = block;
    AddPose(block);
    if (key == 0) continue;
    PoseBlock* const last = &trajectory.blocks[trajectory.blocks.size() - 2];
    OdometrySegment segment =
        trajectory.chain.Between(trajectory.keys[trajectory.blocks.size() - 2], key);
    segment.odometry = Reachable(segment.odometry, *last, *block);
    problem_.AddResidualBlock(new OdometryCost(segment, systematic_sigmas_), nullptr, last->data(),
                              block->data(), trajectory.systematic.data());
  }
  if (selection_.anchored.count(trajectory_id) > 0) {
    problem_.SetParameterBlockConstant(trajectory.blocks.front().data());
  }
}

void GraphProblem::AddSubmap(const SubmapId& submap_id) {
  PoseBlock& block =
      submaps_.emplace(submap_id, ToBlock(graph_.submaps.at(submap_id).map_from_submap))
          .first->second;
  const auto tie = selection_.ties.find(submap_id);
  if (tie == selection_.ties.end()) {
    AddFixedPose(&block);
    return;
  }
  AddPose(&block);
  static const double kNoWeight = 1.;
  PoseBlock* const node = nodes_.at(tie->second.node_id);
  const Matrix6d sqrt_information =
      ToTwist(options_.submap_tie()).cwiseInverse().asDiagonal().toDenseMatrix();
  problem_.AddResidualBlock(
      new RelativePoseCost(Reachable(tie->second.submap_from_node, block, *node), sqrt_information,
                           &kNoWeight),
      nullptr, block.data(), node->data());
}

void GraphProblem::AddLoop(const Constraint& loop, double* weight) {
  if (submaps_.count(loop.submap_id) == 0) AddSubmap(loop.submap_id);
  if (nodes_.count(loop.node_id) == 0) {
    fixed_nodes_.push_back(ToBlock(graph_.nodes.at(loop.node_id).map_from_node));
    nodes_[loop.node_id] = &fixed_nodes_.back();
    AddFixedPose(&fixed_nodes_.back());
  }
  PoseBlock& submap = submaps_.at(loop.submap_id);
  PoseBlock* const node = nodes_.at(loop.node_id);
  loop_residuals_.push_back(problem_.AddResidualBlock(
      new RelativePoseCost(Reachable(loop.submap_from_node, submap, *node),
                           SquareRoot(InformationOf(loop)), weight),
      nullptr, submap.data(), node->data()));
}

std::vector<double> GraphProblem::SquaredLoopErrors() {
  std::fill(weights_.begin(), weights_.end(), 1.);
  std::vector<double> errors;
  for (const ceres::ResidualBlockId loop : loop_residuals_) {
    double cost = 0.;
    problem_.EvaluateResidualBlock(loop, false, &cost, nullptr, nullptr);
    errors.push_back(2. * cost);
  }
  return errors;
}

double GraphProblem::CostWithoutLoops() {
  std::fill(weights_.begin(), weights_.end(), 0.);
  double cost = 0.;
  problem_.Evaluate({}, &cost, nullptr, nullptr, nullptr);
  return cost;
}

GraphProblem::Progress GraphProblem::Solve(const std::vector<double>& weights, int max_iterations) {
  weights_ = weights;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type =
      getenv("EIGEN") ? ceres::EIGEN_SPARSE : ceres::SUITE_SPARSE;
  options.num_threads = getenv("THREADS") ? atoi(getenv("THREADS")) : 1;
  options.max_num_iterations = max_iterations;
  options.initial_trust_region_radius = 1e10;
  options.max_trust_region_radius = 1e16;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem_, &summary);
  if (getenv("VERBOSE")) {
    if (atoi(getenv("VERBOSE")) > 1)
      LOG(INFO) << summary.FullReport();
    else
      LOG(INFO) << summary.BriefReport() << " t " << summary.total_time_in_seconds;
  }
  return {summary.IsSolutionUsable(), summary.termination_type == ceres::CONVERGENCE,
          static_cast<int>(summary.iterations.size()) - 1};
}

void GraphProblem::WriteTo(Graph* graph) const {
  const bool planar = options_.dof() < 6;
  const auto move = [planar](const Rigid3d& to, Rigid3d* pose) {
    *pose = planar ? MovedInPlane(*pose, to) : to;
  };
  for (const auto& [trajectory_id, trajectory] : trajectories_) {
    const Twist twist_per_m = systematic_sigmas_.cwiseProduct(trajectory.systematic);
    for (size_t i = 0; i + 1 < trajectory.keys.size(); ++i) {
      const int start = trajectory.keys[i];
      const int end = trajectory.keys[i + 1];
      const Rigid3d map_from_end = FromBlock(trajectory.blocks[i + 1].data());
      const std::vector<Rigid3d> between = trajectory.chain.PosesBetween(
          start, end, FromBlock(trajectory.blocks[i].data()), map_from_end, twist_per_m);
      for (int k = start + 1; k < end; ++k) {
        move(between[k - start - 1], &graph->nodes.at(trajectory.ids[k]).map_from_node);
      }
      move(map_from_end, &graph->nodes.at(trajectory.ids[end]).map_from_node);
    }
    if (selection_.anchored.count(trajectory_id) == 0) {
      move(FromBlock(trajectory.blocks.front().data()),
           &graph->nodes.at(trajectory.ids.front()).map_from_node);
    }
  }
  for (const auto& [submap_id, tie] : selection_.ties) {
    if (trajectories_.count(submap_id.trajectory_id) == 0) continue;
    const auto it = submaps_.find(submap_id);
    const Rigid3d to = it != submaps_.end() ? FromBlock(it->second.data())
                                            : graph->nodes.at(tie.node_id).map_from_node *
                                                  tie.submap_from_node.inverse();
    move(to, &graph->submaps.at(submap_id).map_from_submap);
  }
}

std::map<int, Twist> GraphProblem::TwistsPerMetre() const {
  std::map<int, Twist> twists;
  for (const auto& [trajectory_id, trajectory] : trajectories_) {
    twists[trajectory_id] = systematic_sigmas_.cwiseProduct(trajectory.systematic);
  }
  return twists;
}

}  // namespace cartographer::pose_graph
