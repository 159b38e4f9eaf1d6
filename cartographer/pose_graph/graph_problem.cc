// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/graph_problem.h"

#include <algorithm>

#include "cartographer/pose_graph/constraint_information.h"
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

// Steps that are put together are this short, so that the systematic error may be taken to first
// order in them.
constexpr double kMaxSegment_m = 50.;

constexpr double kFullWeight = 1.;

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

std::unique_ptr<ceres::Manifold> MakeManifold(bool planar) {
  if (planar) return std::make_unique<PlanarPoseManifold>();
  return std::make_unique<PoseManifold>();
}

// The nodes that loops tie to something, and those on which their submaps hang.
std::set<NodeId> TiedNodes(const GraphSelection& selection) {
  std::set<NodeId> tied;
  for (const Constraint* loop : selection.loops) {
    tied.insert(loop->node_id);
    const auto tie = selection.ties.find(loop->submap_id);
    if (tie != selection.ties.end()) tied.insert(tie->second.node_id);
  }
  return tied;
}

std::vector<int> SelectKeys(const OdometryChain& chain, const std::set<NodeId>& tied) {
  std::vector<int> keys = {0};
  for (int i = 1; i < chain.size(); ++i) {
    const bool is_far = chain.distance_m(i) - chain.distance_m(keys.back()) > kMaxSegment_m;
    if (is_far && i - 1 > keys.back()) keys.push_back(i - 1);
    if (tied.count(chain.id(i)) > 0 || i + 1 == chain.size()) keys.push_back(i);
  }
  return keys;
}

// Without BLAS and on one thread the sums have one order, whatever the machine has; more threads
// would gain next to nothing.
ceres::Solver::Options SolverOptions(int max_iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = max_iterations;
  // All but undamped: graphs are nearly linear once their odometry is this good.
  options.initial_trust_region_radius = 1e10;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

GraphProblem::GraphProblem(const proto::OptimizationOptions& options, const Graph& graph,
                           const GraphSelection& selection,
                           const std::map<int, OdometryChain>& chains)
    : options_(options),
      graph_(graph),
      selection_(selection),
      chains_(chains),
      planar_(options.dof() < 6),
      systematic_sigmas_(ToTwist(options.odometry().systematic())),
      tie_sqrt_information_(PositiveSigmas(options.submap_tie()).cwiseInverse().asDiagonal()),
      manifold_(MakeManifold(planar_)),
      weights_(selection.loops.size(), 1.),
      problem_(ProblemOptions()) {
  const std::set<NodeId> tied = TiedNodes(selection);
  for (const int trajectory_id : selection.moving) AddTrajectory(trajectory_id, tied);
  for (size_t i = 0; i < selection.loops.size(); ++i) AddLoop(*selection.loops[i], &weights_[i]);
}

void GraphProblem::AddPose(PoseBlock* block, bool fixed) {
  problem_.AddParameterBlock(block->data(), kPoseBlockSize, manifold_.get());
  if (fixed) problem_.SetParameterBlockConstant(block->data());
}

Rigid3d GraphProblem::Attainable(const Rigid3d& a_from_b, const PoseBlock& a,
                                 const PoseBlock& b) const {
  if (!planar_) return a_from_b;
  const Rigid3d map_from_a = FromBlock(a.data());
  return map_from_a.inverse() * MovedInPlane(FromBlock(b.data()), map_from_a * a_from_b);
}

void GraphProblem::AddTrajectory(int trajectory_id, const std::set<NodeId>& tied) {
  const OdometryChain& chain = chains_.at(trajectory_id);
  Trajectory& trajectory =
      trajectories_.emplace(trajectory_id, Trajectory{&chain, SelectKeys(chain, tied), {}})
          .first->second;
  problem_.AddResidualBlock(
      new ceres::NormalPrior(ceres::Matrix::Identity(6, 6), ceres::Vector::Zero(6)), nullptr,
      trajectory.systematic.data());
  const bool anchored = selection_.anchored.count(trajectory_id) > 0;
  for (const int key : trajectory.keys) {
    const NodeId& id = chain.id(key);
    trajectory.blocks.push_back(ToBlock(graph_.nodes.at(id).map_from_node));
    PoseBlock* const block = &trajectory.blocks.back();
    nodes_[id] = block;
    AddPose(block, anchored && key == 0);
  }
  for (size_t i = 0; i + 1 < trajectory.keys.size(); ++i) AddOdometry(&trajectory, i);
}

void GraphProblem::AddOdometry(Trajectory* trajectory, size_t from_key) {
  PoseBlock& start = trajectory->blocks[from_key];
  PoseBlock& end = trajectory->blocks[from_key + 1];
  OdometrySegment segment =
      trajectory->chain->Between(trajectory->keys[from_key], trajectory->keys[from_key + 1]);
  segment.odometry = Attainable(segment.odometry, start, end);
  problem_.AddResidualBlock(new OdometryCost(segment, systematic_sigmas_), nullptr, start.data(),
                            end.data(), trajectory->systematic.data());
}

void GraphProblem::AddSubmap(const SubmapId& submap_id) {
  PoseBlock& block =
      submaps_.emplace(submap_id, ToBlock(graph_.submaps.at(submap_id).map_from_submap))
          .first->second;
  const auto tie = selection_.ties.find(submap_id);
  AddPose(&block, tie == selection_.ties.end());
  if (tie == selection_.ties.end()) return;
  PoseBlock& node = *nodes_.at(tie->second.node_id);
  problem_.AddResidualBlock(
      new RelativePoseCost(Attainable(tie->second.submap_from_node, block, node),
                           tie_sqrt_information_, &kFullWeight),
      nullptr, block.data(), node.data());
}

void GraphProblem::AddLoop(const Constraint& loop, double* weight) {
  if (submaps_.count(loop.submap_id) == 0) AddSubmap(loop.submap_id);
  if (nodes_.count(loop.node_id) == 0) {
    frozen_nodes_.push_back(ToBlock(graph_.nodes.at(loop.node_id).map_from_node));
    nodes_[loop.node_id] = &frozen_nodes_.back();
    AddPose(&frozen_nodes_.back(), true);
  }
  PoseBlock& submap = submaps_.at(loop.submap_id);
  PoseBlock& node = *nodes_.at(loop.node_id);
  const Matrix6d information = InformationOf(loop);
  loop_residuals_.push_back(problem_.AddResidualBlock(
      new RelativePoseCost(Attainable(loop.submap_from_node, submap, node),
                           SquareRoot(planar_ ? PlanarInformation(information) : information),
                           weight),
      nullptr, submap.data(), node.data()));
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
  CHECK_EQ(weights.size(), weights_.size());
  weights_ = weights;
  ceres::Solver::Summary summary;
  ceres::Solve(SolverOptions(max_iterations), &problem_, &summary);
  return {summary.IsSolutionUsable(), summary.termination_type == ceres::CONVERGENCE,
          std::max(0, static_cast<int>(summary.iterations.size()) - 1)};
}

void GraphProblem::Move(const Rigid3d& to, Rigid3d* pose) const {
  *pose = planar_ ? MovedInPlane(*pose, to) : to;
}

void GraphProblem::WriteTrajectory(int trajectory_id, Graph* graph) const {
  const Trajectory& trajectory = trajectories_.at(trajectory_id);
  const OdometryChain& chain = *trajectory.chain;
  const Twist twist_per_m = systematic_sigmas_.cwiseProduct(trajectory.systematic);
  const auto move = [&](int node, const Rigid3d& to) {
    Move(to, &graph->nodes.at(chain.id(node)).map_from_node);
  };
  // A node that stays does so to the bit.
  if (selection_.anchored.count(trajectory_id) == 0) {
    move(0, FromBlock(trajectory.blocks.front().data()));
  }
  for (size_t i = 0; i + 1 < trajectory.keys.size(); ++i) {
    const int start = trajectory.keys[i];
    const int end = trajectory.keys[i + 1];
    const Rigid3d map_from_end = FromBlock(trajectory.blocks[i + 1].data());
    const std::vector<Rigid3d> between = chain.PosesBetween(
        start, end, FromBlock(trajectory.blocks[i].data()), map_from_end, twist_per_m);
    for (int node = start + 1; node < end; ++node) move(node, between[node - start - 1]);
    move(end, map_from_end);
  }
}

void GraphProblem::WriteTo(Graph* graph) const {
  for (const int trajectory_id : selection_.moving) WriteTrajectory(trajectory_id, graph);
  for (const auto& [submap_id, tie] : selection_.ties) {
    if (selection_.moving.count(submap_id.trajectory_id) == 0) continue;
    const auto unknown = submaps_.find(submap_id);
    const Rigid3d to = unknown != submaps_.end() ? FromBlock(unknown->second.data())
                                                 : graph->nodes.at(tie.node_id).map_from_node *
                                                       tie.submap_from_node.inverse();
    Move(to, &graph->submaps.at(submap_id).map_from_submap);
  }
}

std::map<int, Twist> GraphProblem::SystematicErrors() const {
  std::map<int, Twist> errors;
  for (const auto& [trajectory_id, trajectory] : trajectories_) {
    errors[trajectory_id] = systematic_sigmas_.cwiseProduct(trajectory.systematic);
  }
  return errors;
}

}  // namespace cartographer::pose_graph
