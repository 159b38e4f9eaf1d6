// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_AGREEMENT_H_
#define CARTOGRAPHER_POSE_GRAPH_AGREEMENT_H_

#include <vector>

#include "cartographer/pose_graph/closure.h"
#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/proto/pose_graph_options.pb.h"
#include "cartographer/pose_graph/topology.h"

namespace cartographer::pose_graph {

// What a closure says of the map's estimate: the pose that it wants its node to have, in the map
// frame, the submap held where it is, as a motion away from the node's present pose:
// corrected_from_estimate = map_from_submap * submap_from_node * map_from_node^-1.
transform::Rigid3d CorrectionBy(const submap::Constraint& closure, const Graph& graph);

// Whether two closures tell the same story: the nodes are of the same trajectory and near each
// other on it, and both corrections put the node that comes between them in the same place.
bool Agree(const submap::Constraint& a, const submap::Constraint& b, const Graph& graph,
           const Topology& topology, const proto::AgreementOptions& options);

// For each of the first `num_asking` closures, how many of all the others agree with it. Those at
// the same node do not count: they share its errors.
std::vector<int> CountAgreeing(const std::vector<Closure>& closures, size_t num_asking,
                               const Graph& graph, const Topology& topology,
                               const proto::AgreementOptions& options);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_AGREEMENT_H_
