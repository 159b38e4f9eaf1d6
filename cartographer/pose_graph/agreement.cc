// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/agreement.h"

#include <cmath>

namespace cartographer::pose_graph {

using submap::Constraint;
using transform::Rigid3d;

Rigid3d CorrectionBy(const Constraint& closure, const Graph& graph) {
  const Rigid3d& map_from_submap = graph.submaps.at(closure.submap_id).map_from_submap;
  const Rigid3d& map_from_node = graph.nodes.at(closure.node_id).map_from_node;
  return map_from_submap * closure.submap_from_node * map_from_node.inverse();
}

bool Agree(const Constraint& a, const Constraint& b, const Graph& graph, const Topology& topology,
           const proto::AgreementOptions& options) {
  if (a.node_id.trajectory_id != b.node_id.trajectory_id) return false;
  const double travel_m = std::abs(topology.DrivenTo(a.node_id) - topology.DrivenTo(b.node_id));
  if (travel_m > options.max_travel_m()) return false;
  const Rigid3d by_a = CorrectionBy(a, graph);
  const Rigid3d by_b = CorrectionBy(b, graph);
  const double angle_deg = transform::RotationAngle(by_a.inverse() * by_b) * 180. / M_PI;
  const Eigen::Vector3d between = 0.5 * (graph.nodes.at(a.node_id).map_from_node.translation() +
                                         graph.nodes.at(b.node_id).map_from_node.translation());
  const double distance_m = (by_a * between - by_b * between).norm();
  return angle_deg <= options.max_angle_deg() &&
         distance_m <= options.max_distance_m() + options.max_distance_m_per_m() * travel_m;
}

std::vector<int> CountAgreeing(const std::vector<Closure>& closures, size_t num_asking,
                               const Graph& graph, const Topology& topology,
                               const proto::AgreementOptions& options) {
  std::vector<int> counts(num_asking, 0);
  for (size_t i = 0; i < num_asking; ++i) {
    const Constraint& asking = closures[i].constraint;
    for (const Closure& other : closures) {
      if (other.constraint.node_id == asking.node_id) continue;
      if (Agree(asking, other.constraint, graph, topology, options)) ++counts[i];
    }
  }
  return counts;
}

}  // namespace cartographer::pose_graph
