// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/loop_plausibility.h"

#include <cmath>
#include <optional>

#include "cartographer/pose_graph/constraint_information.h"
#include "cartographer/pose_graph/odometry_uncertainty.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using transform::Rigid3d;

constexpr double kNeighbourhood_m = 50.;

double Square(double x) { return x * x; }

// A loop as a relation of two nodes of one trajectory: the submap is where its middle node is.
struct Loop {
  int trajectory_id;
  int submap_node;
  int node;
  Rigid3d submap_node_from_node;
  PoseVariance variance;
};

std::optional<Loop> AsLoop(const Constraint& constraint, const GraphSelection& selection,
                           const std::map<int, OdometryChain>& chains) {
  const int trajectory_id = constraint.node_id.trajectory_id;
  if (constraint.submap_id.trajectory_id != trajectory_id) return std::nullopt;
  const OdometryChain& chain = chains.at(trajectory_id);
  const SubmapTie& tie = selection.ties.at(constraint.submap_id);
  const transform::Matrix6d information = InformationOf(constraint);
  return Loop{trajectory_id,
              chain.IndexOf(tie.node_id),
              chain.IndexOf(constraint.node_id),
              tie.submap_from_node.inverse() * constraint.submap_from_node,
              {3. / information.topLeftCorner<3, 3>().trace(),
               3. / information.bottomRightCorner<3, 3>().trace()}};
}

class Judge {
 public:
  Judge(const proto::OptimizationOptions& options, const OdometryChain& chain)
      : planar_(options.dof() < 6), chain_(chain), uncertainty_(options.odometry(), chain) {}

  // Squared errors in standard deviations. Of the loop against the odometry,
  double AgainstOdometry(const Loop& loop) const {
    return SquaredError(loop, OdometryBetween(loop.submap_node, loop.node),
                        loop.variance + uncertainty_.Between(loop.submap_node, loop.node));
  }
  // and against another loop beside it, to which the odometry leads from both ends.
  double AgainstLoop(const Loop& loop, const Loop& other) const {
    const Rigid3d expected = OdometryBetween(loop.submap_node, other.submap_node) *
                             other.submap_node_from_node * OdometryBetween(other.node, loop.node);
    return SquaredError(loop, expected,
                        loop.variance + other.variance +
                            uncertainty_.Between(loop.submap_node, other.submap_node) +
                            uncertainty_.Between(loop.node, other.node));
  }
  bool AreNeighbours(const Loop& a, const Loop& b) const {
    return Apart_m(a.submap_node, b.submap_node) <= kNeighbourhood_m &&
           Apart_m(a.node, b.node) <= kNeighbourhood_m;
  }

 private:
  double Apart_m(int a, int b) const {
    return std::abs(chain_.distance_m(a) - chain_.distance_m(b));
  }
  Rigid3d OdometryBetween(int a, int b) const {
    return chain_.local_from_node(a).inverse() * chain_.local_from_node(b);
  }
  double SquaredError(const Loop& loop, const Rigid3d& expected,
                      const PoseVariance& variance) const {
    const Rigid3d& local_from_start = chain_.local_from_node(loop.submap_node);
    const Rigid3d is = local_from_start * loop.submap_node_from_node;
    const Rigid3d should_be = local_from_start * expected;
    Eigen::Vector3d apart_m = should_be.translation() - is.translation();
    double turned_rad = transform::RotationAngle(is.inverse() * should_be);
    if (planar_) {
      apart_m.z() = 0.;
      turned_rad = transform::Yaw(should_be.rotation() * is.rotation().conjugate());
    }
    return apart_m.squaredNorm() / variance.translation_m2 +
           Square(turned_rad) / variance.rotation_rad2;
  }

  const bool planar_;
  const OdometryChain& chain_;
  const OdometryUncertainty uncertainty_;
};

// Calls visit(j) for the loops beside loops[i], itself included, that say the same as it.
template <typename Visitor>
void ForAllAlike(const std::vector<std::optional<Loop>>& loops, size_t i, const Judge& judge,
                 double tolerance, const Visitor& visit) {
  for (size_t j = 0; j < loops.size(); ++j) {
    if (!loops[j].has_value() || loops[j]->trajectory_id != loops[i]->trajectory_id) continue;
    if (!judge.AreNeighbours(*loops[i], *loops[j])) continue;
    if (judge.AgainstLoop(*loops[i], *loops[j]) <= tolerance) visit(j);
  }
}

}  // namespace

std::vector<bool> FindPlausibleLoops(const proto::OptimizationOptions& options,
                                     const GraphSelection& selection,
                                     const std::map<int, OdometryChain>& chains) {
  std::map<int, Judge> judges;
  for (const auto& [id, chain] : chains) judges.try_emplace(id, options, chain);
  std::vector<std::optional<Loop>> loops;
  for (const Constraint* constraint : selection.loops) {
    loops.push_back(AsLoop(*constraint, selection, chains));
  }
  const double tolerance = Square(options.loop_scale_sigmas());
  std::vector<bool> plausible(loops.size(), true);
  for (size_t i = 0; i < loops.size(); ++i) {
    if (!loops[i].has_value()) continue;
    const Judge& judge = judges.at(loops[i]->trajectory_id);
    const double error = judge.AgainstOdometry(*loops[i]);
    if (error <= tolerance) continue;
    int num_alike = 0;
    ForAllAlike(loops, i, judge, tolerance, [&](size_t) { ++num_alike; });
    plausible[i] = error <= Square(num_alike) * tolerance;
  }
  // What is at the edge of a group has fewer neighbours.
  std::vector<size_t> to_ask_from;
  for (size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].has_value() && plausible[i]) to_ask_from.push_back(i);
  }
  bool all = std::all_of(plausible.begin(), plausible.end(), [](bool b) { return b; });
  while (!to_ask_from.empty() && !all) {
    const size_t i = to_ask_from.back();
    to_ask_from.pop_back();
    ForAllAlike(loops, i, judges.at(loops[i]->trajectory_id), tolerance, [&](size_t j) {
      if (plausible[j]) return;
      plausible[j] = true;
      to_ask_from.push_back(j);
    });
  }
  return plausible;
}

}  // namespace cartographer::pose_graph
