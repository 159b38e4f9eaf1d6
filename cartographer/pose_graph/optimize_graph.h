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
  // False if the limit of iterations came first, or the solver failed; poses are then the best that
  // were found.
  bool converged = true;
  int iterations = 0;
  // Half the sum of squared errors in standard deviations, those of loops through their kernel.
  double initial_cost = 0.;
  double final_cost = 0.;
  int num_loops = 0;     // that could be used
  int num_rejected = 0;  // of those, whose weight fell below a tenth
  // By trajectory that moved: the systematic error of its odometry, per metre driven, in the frame
  // of its nodes.
  std::map<int, transform::Twist> twist_per_m;
};

OptimizationReport OptimizeGraph(const proto::OptimizationOptions& options, Graph* graph);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_OPTIMIZE_GRAPH_H_
