// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_OPTIMIZE_GRAPH_H_
#define CARTOGRAPHER_POSE_GRAPH_OPTIMIZE_GRAPH_H_

#include <map>

#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/proto/optimization_options.pb.h"
#include "cartographer/transform/se3.h"

namespace cartographer::pose_graph {

struct OptimizationReport {
  // False if the solver failed: the graph is as it was.
  bool usable = true;
  // False if the limit of iterations came first, or if the solver failed.
  bool converged = true;
  int iterations = 0;
  // Half the sum of squared errors in standard deviations, those of loops through their kernel.
  double initial_cost = 0.;
  double final_cost = 0.;
  int num_loops = 0;     // that say something: finite, between things that exist and can move
  int num_rejected = 0;  // of these, that pull with less than a tenth of their weight in the end
  // By trajectory that moved: the systematic correction of its odometry, per metre driven, as a
  // twist in the frame of its nodes; truth = odometry * Exp(distance * twist).
  std::map<int, transform::Twist> correction_per_m;
};

// Moves the nodes and submaps of all trajectories that are not frozen to where the constraints want
// them: the most likely poses given
//   - the odometry between consecutive nodes, which errs at random and systematically,
//   - what ties each submap to its middle node,
//   - the loop constraints (kInterSubmap), through a robust kernel.
// docs/decisions/0007-*.md tells why these. The other intra-submap constraints say again what the
// odometry says and are not used.
//
// What stays, to the bit: all of a trajectory that no loop ties to anything, so everything if there
// are no loops; frozen trajectories; the first node of a trajectory, if loops tie it to none before
// it and to no frozen one; with dof = 3, heights. Submaps without nodes of their own stay, too.
// Loops that are not finite, or whose node or submap is missing, are ignored; if the solver fails,
// nothing moves.
//
// `map_from_node` and `map_from_submap` are where the search begins: of what is new since the last
// optimization, the caller puts it where its local pose is from the last node that was in it.
// The same bytes on any number of threads; runs on one.
OptimizationReport OptimizeGraph(const proto::OptimizationOptions& options, Graph* graph);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_OPTIMIZE_GRAPH_H_
