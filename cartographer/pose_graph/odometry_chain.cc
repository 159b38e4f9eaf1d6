// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/odometry_chain.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "glog/logging.h"

namespace cartographer::pose_graph {

using transform::Adjoint;
using transform::Exp;
using transform::Log;
using transform::Matrix6d;
using transform::Rigid3d;
using transform::Twist;

Twist ToTwist(const proto::PoseSigmas& sigmas) {
  constexpr double kRadPerDeg = M_PI / 180.;
  Twist twist;
  twist << sigmas.forward_m(), sigmas.left_m(), sigmas.up_m(), sigmas.tilt_deg() * kRadPerDeg,
      sigmas.tilt_deg() * kRadPerDeg, sigmas.heading_deg() * kRadPerDeg;
  return twist;
}

Twist PositiveSigmas(const proto::PoseSigmas& sigmas) { return ToTwist(sigmas).cwiseMax(1e-6); }

OdometryChain::OdometryChain(const proto::OdometryErrorOptions& options, const Graph& graph,
                             int trajectory_id)
    : variances_per_m_(PositiveSigmas(options.random()).cwiseAbs2()),
      min_step_m_(options.min_step_m()) {
  for (auto it = graph.nodes.lower_bound(submap::NodeId{trajectory_id, 0});
       it != graph.nodes.end() && it->first.trajectory_id == trajectory_id; ++it) {
    const Rigid3d& pose = it->second.local_from_node;
    const double step_m =
        ids_.empty() ? 0. : (pose.translation() - local_from_node_.back().translation()).norm();
    distance_m_.push_back(ids_.empty() ? 0. : distance_m_.back() + step_m);
    ids_.push_back(it->first);
    local_from_node_.push_back(pose);
  }
  CHECK(!ids_.empty());
}

int OdometryChain::IndexOf(const submap::NodeId& id) const {
  const auto it = std::lower_bound(ids_.begin(), ids_.end(), id);
  CHECK(it != ids_.end() && *it == id);
  return static_cast<int>(it - ids_.begin());
}

void OdometryChain::AppendStep(int node, OdometrySegment* segment) const {
  const Rigid3d step = local_from_node_[node].inverse() * local_from_node_[node + 1];
  const double length_m = distance_m_[node + 1] - distance_m_[node];
  const Matrix6d adjoint = Adjoint(step.inverse());
  segment->odometry = segment->odometry * step;
  segment->drift = adjoint * segment->drift;
  segment->drift.diagonal().array() += length_m;
  segment->covariance = adjoint * segment->covariance * adjoint.transpose();
  segment->covariance.diagonal() += std::max(length_m, min_step_m_) * variances_per_m_;
}

OdometrySegment OdometryChain::Between(int start, int end) const {
  CHECK_LE(0, start);
  CHECK_LT(start, end);
  CHECK_LT(end, size());
  OdometrySegment segment;
  for (int node = start; node < end; ++node) AppendStep(node, &segment);
  return segment;
}

std::vector<Rigid3d> OdometryChain::PosesBetween(int start, int end, const Rigid3d& map_from_start,
                                                 const Rigid3d& map_from_end,
                                                 const Twist& twist_per_m) const {
  std::vector<OdometrySegment> to_node(1);
  for (int node = start; node < end; ++node) {
    to_node.push_back(to_node.back());
    AppendStep(node, &to_node.back());
  }
  const auto predict = [&](const OdometrySegment& segment) {
    return map_from_start * segment.odometry * Exp(segment.drift * twist_per_m);
  };
  const OdometrySegment& whole = to_node.back();
  const Twist contradiction = Log(predict(whole).inverse() * map_from_end);
  const Twist per_covariance = whole.covariance.llt().solve(contradiction);
  const Rigid3d end_from_start = whole.odometry.inverse();
  std::vector<Rigid3d> poses;
  for (int i = 1; i < end - start; ++i) {
    // Conditional mean of the noise up to the node, given the noise up to the end.
    const Matrix6d end_from_node = Adjoint(end_from_start * to_node[i].odometry);
    const Twist noise = to_node[i].covariance * (end_from_node.transpose() * per_covariance);
    poses.push_back(predict(to_node[i]) * Exp(noise));
  }
  return poses;
}

}  // namespace cartographer::pose_graph
