// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_POSE_GRAPH_MADE_UP_DRIVE_H_
#define TEST_CARTOGRAPHER_POSE_GRAPH_MADE_UP_DRIVE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/proto/optimization_options.pb.h"
#include "cartographer/submap/id.h"
#include "cartographer/transform/rigid_transform.h"
#include "cartographer/transform/se3.h"

namespace cartographer::pose_graph {

// The shipped options, after Lua statements that may change the table OPTIMIZATION.
proto::OptimizationOptions OptimizationDefaults(const std::string& changes = "");

using Poses = std::vector<transform::Rigid3d>;

// True poses, map_from_node, of a drive over hills on a closed track of some 340 m with bends to
// both sides: kNodesPerLap nodes a lap, the same ones on every lap.
constexpr int kNodesPerLap = 120;
Poses Laps(double num_laps);

// The drive as an odometry has it that begins at the first true pose and errs at each step of d
// metres by Exp(d * twist_per_m) * Exp(noise), the noise with `sigmas_per_sqrt_m` * sqrt(d).
struct OdometryErrors {
  transform::Twist twist_per_m = transform::Twist::Zero();
  transform::Twist sigmas_per_sqrt_m = transform::Twist::Zero();
  uint32_t seed = 1;
};
Poses WithErrors(const Poses& truth, const OdometryErrors& errors);

// About twice as wrong as the options expect.
OdometryErrors RandomErrors();

// Appends a trajectory as it is before any optimization: nodes at `odometry`, a submap of ten of
// them for every five.
void AddTrajectory(int trajectory_id, const Poses& odometry, Graph* graph);

// The constraint that would put the node exactly where it is relative to the submap, or rather to
// the node in the submap's middle, with standard deviations of 0.05 m and 0.1 degrees.
submap::Constraint TrueLoop(const Graph& graph, const submap::SubmapId& submap_id,
                            const Poses& truth_of_submap, const submap::NodeId& node_id,
                            const Poses& truth_of_node);

// Adds such loops for every fourth node that is at least `min_laps` after a visit of the same
// place, to the submap there.
void AddTrueLoops(int trajectory_id, const Poses& truth, double min_laps, Graph* graph);

// The drive with such loops.
Graph DriftedGraph(const Poses& truth, const OdometryErrors& errors, double min_laps = 1.);

// The largest distance of a node from where it should be.
double LargestError_m(const Graph& graph, int trajectory_id, const Poses& should_be);

// All poses, to the bit.
std::string Bytes(const Graph& graph);

}  // namespace cartographer::pose_graph

#endif  // TEST_CARTOGRAPHER_POSE_GRAPH_MADE_UP_DRIVE_H_
