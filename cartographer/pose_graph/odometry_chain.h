// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_ODOMETRY_CHAIN_H_
#define CARTOGRAPHER_POSE_GRAPH_ODOMETRY_CHAIN_H_

#include <vector>

#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/proto/optimization_options.pb.h"
#include "cartographer/submap/id.h"
#include "cartographer/transform/rigid_transform.h"
#include "cartographer/transform/se3.h"
#include "cartographer/transform/se3_jacobian.h"

namespace cartographer::pose_graph {

// The standard deviations as a diagonal, ordered as transform::Twist, in m and rad.
transform::Twist ToTwist(const proto::PoseSigmas& sigmas);
// The same for what may not be 0: a micrometre or microradian at least.
transform::Twist PositiveSigmas(const proto::PoseSigmas& sigmas);

// What the odometry says of two nodes of a trajectory, with all steps between them put together:
//
//   start_from_end = odometry * Exp(drift * twist_per_m) * Exp(noise),  noise ~ N(0, covariance),
//
// to first order in the systematic error `twist_per_m`.
struct OdometrySegment {
  transform::Rigid3d odometry;  // start_from_end
  transform::Matrix6d drift = transform::Matrix6d::Zero();
  transform::Matrix6d covariance = transform::Matrix6d::Zero();
};

// The odometry of one trajectory. The error of a step of the length d is Exp(d * twist_per_m)
// * Exp(noise), in the frame of its end, where the noise has variances that grow with d; so it is a
// random walk on top of a drift. Nodes count by their place in the trajectory, from 0.
class OdometryChain {
 public:
  // The trajectory must have nodes (CHECKed).
  OdometryChain(const proto::OdometryErrorOptions& options, const Graph& graph, int trajectory_id);

  int size() const { return static_cast<int>(ids_.size()); }
  const submap::NodeId& id(int node) const { return ids_[node]; }
  // The place of a node that is in the trajectory (CHECKed).
  int IndexOf(const submap::NodeId& id) const;
  const transform::Rigid3d& local_from_node(int node) const { return local_from_node_[node]; }
  // Driven up to the node [m].
  double distance_m(int node) const { return distance_m_[node]; }

  // 0 <= start < end < size() (CHECKed).
  OdometrySegment Between(int start, int end) const;

  // The most likely poses of the nodes start + 1 ... end - 1, given those of start and end: what
  // these contradict the odometry is spread by what each step contributes to the uncertainty.
  std::vector<transform::Rigid3d> PosesBetween(int start, int end,
                                               const transform::Rigid3d& map_from_start,
                                               const transform::Rigid3d& map_from_end,
                                               const transform::Twist& twist_per_m) const;

 private:
  // Lengthens the segment by the step from `node` to its successor.
  void AppendStep(int node, OdometrySegment* segment) const;

  const transform::Twist variances_per_m_;
  const double min_step_m_;
  std::vector<submap::NodeId> ids_;
  std::vector<transform::Rigid3d> local_from_node_;
  std::vector<double> distance_m_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_ODOMETRY_CHAIN_H_
