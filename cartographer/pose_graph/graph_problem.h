// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_GRAPH_PROBLEM_H_
#define CARTOGRAPHER_POSE_GRAPH_GRAPH_PROBLEM_H_

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/graph_selection.h"
#include "cartographer/pose_graph/odometry_chain.h"
#include "cartographer/pose_graph/pose_block.h"
#include "cartographer/pose_graph/proto/optimization_options.pb.h"
#include "ceres/problem.h"

namespace cartographer::pose_graph {

class GraphProblem {
 public:
  GraphProblem(const proto::OptimizationOptions& options, const Graph& graph,
               const GraphSelection& selection);
  GraphProblem(const GraphProblem&) = delete;
  GraphProblem& operator=(const GraphProblem&) = delete;

  // Squared errors of the loops in standard deviations, in the order of the selection.
  std::vector<double> SquaredLoopErrors();
  // Half the sum of squared errors of everything but the loops.
  double CostWithoutLoops();

  struct Progress {
    bool usable;
    bool converged;
    int iterations;
  };
  // `weights` scale the squared errors of the loops.
  Progress Solve(const std::vector<double>& weights, int max_iterations);

  // Puts nodes and submaps of moving trajectories where the solution has them.
  void WriteTo(Graph* graph) const;
  std::map<int, transform::Twist> TwistsPerMetre() const;

 private:
  struct Trajectory {
    std::vector<submap::NodeId> ids;
    OdometryChain chain;
    std::vector<int> keys;         // of `ids`: nodes that are vertices, ascending
    std::deque<PoseBlock> blocks;  // their poses
    transform::Twist systematic = transform::Twist::Zero();  // in units of its expected size
  };

  void AddTrajectory(int trajectory_id, const std::set<submap::NodeId>& tied);
  void AddSubmap(const submap::SubmapId& submap_id);
  void AddLoop(const submap::Constraint& loop, double* weight);
  double* NodeBlock(const submap::NodeId& node_id);
  void AddPose(PoseBlock* block);
  void AddFixedPose(PoseBlock* block);
  // What a measurement says of the poses' relation as far as they may move.
  transform::Rigid3d Reachable(const transform::Rigid3d& a_from_b, const PoseBlock& a,
                               const PoseBlock& b) const;

  const proto::OptimizationOptions options_;
  const Graph& graph_;
  const GraphSelection& selection_;
  const transform::Twist systematic_sigmas_;
  const std::unique_ptr<ceres::Manifold> manifold_;
  std::map<int, Trajectory> trajectories_;
  std::map<submap::NodeId, PoseBlock*> nodes_;
  std::map<submap::SubmapId, PoseBlock> submaps_;
  std::deque<PoseBlock> fixed_nodes_;
  std::vector<double> weights_;
  std::vector<ceres::ResidualBlockId> loop_residuals_;
  ceres::Problem problem_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_GRAPH_PROBLEM_H_
