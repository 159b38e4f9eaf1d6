// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_GRAPH_PROBLEM_H_
#define CARTOGRAPHER_POSE_GRAPH_GRAPH_PROBLEM_H_

#include <deque>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "cartographer/pose_graph/graph.h"
#include "cartographer/pose_graph/graph_selection.h"
#include "cartographer/pose_graph/odometry_chain.h"
#include "cartographer/pose_graph/pose_block.h"
#include "cartographer/pose_graph/proto/optimization_options.pb.h"
#include "ceres/problem.h"

namespace cartographer::pose_graph {

// The least squares problem of a graph. Of its poses only those are unknowns that have something to
// say: the nodes and submaps of loops, the nodes that these submaps hang on, both ends of each
// trajectory, and a node every 50 m. Between them stands the odometry of all steps put together;
// the nodes that are left out are filled in when the solution is written back. That is the same
// solution, from a problem a fifth of the size.
class GraphProblem {
 public:
  // `chains` has all moving trajectories of the selection. All arguments must outlive the problem.
  GraphProblem(const proto::OptimizationOptions& options, const Graph& graph,
               const GraphSelection& selection, const std::map<int, OdometryChain>& chains);
  GraphProblem(const GraphProblem&) = delete;
  GraphProblem& operator=(const GraphProblem&) = delete;

  // Squared errors of the loops in standard deviations, in the order of the selection.
  std::vector<double> SquaredLoopErrors();
  // Half the sum of the other squared errors.
  double CostWithoutLoops();

  struct Progress {
    bool usable;
    bool converged;
    int iterations;
  };
  // Solves with the squared errors of the loops scaled by `weights`, from where the last solution
  // is. The unknowns stay as they are if no better ones are found.
  Progress Solve(const std::vector<double>& weights, int max_iterations);

  // Puts nodes and submaps of moving trajectories where the solution has them. `graph` is equal to
  // the one that the problem was made of.
  void WriteTo(Graph* graph) const;
  // By moving trajectory: the systematic error of its odometry, per metre.
  std::map<int, transform::Twist> SystematicErrors() const;

 private:
  struct Trajectory {
    const OdometryChain* chain;
    std::vector<int> keys;         // the nodes that are unknowns, ascending
    std::deque<PoseBlock> blocks;  // their poses
    transform::Twist systematic = transform::Twist::Zero();  // in units of its expected size
  };

  void AddTrajectory(int trajectory_id, const std::set<submap::NodeId>& tied);
  void AddOdometry(Trajectory* trajectory, size_t from_key);
  void AddSubmap(const submap::SubmapId& submap_id);
  void AddLoop(const submap::Constraint& loop, double* weight);
  void AddPose(PoseBlock* block, bool fixed);
  // `a_from_b` as it is, or what is left of it if poses move in the plane only: then its height and
  // tilt are those that the poses have, which is no contradiction.
  transform::Rigid3d Attainable(const transform::Rigid3d& a_from_b, const PoseBlock& a,
                                const PoseBlock& b) const;
  void WriteTrajectory(int trajectory_id, Graph* graph) const;
  void Move(const transform::Rigid3d& to, transform::Rigid3d* pose) const;

  const proto::OptimizationOptions& options_;
  const Graph& graph_;
  const GraphSelection& selection_;
  const std::map<int, OdometryChain>& chains_;
  const bool planar_;
  const transform::Twist systematic_sigmas_;
  const transform::Matrix6d tie_sqrt_information_;
  const std::unique_ptr<ceres::Manifold> manifold_;
  std::map<int, Trajectory> trajectories_;
  std::map<submap::NodeId, PoseBlock*> nodes_;
  std::map<submap::SubmapId, PoseBlock> submaps_;
  std::deque<PoseBlock> frozen_nodes_;
  std::vector<double> weights_;
  std::vector<ceres::ResidualBlockId> loop_residuals_;
  ceres::Problem problem_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_GRAPH_PROBLEM_H_
