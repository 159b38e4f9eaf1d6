// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_MAP_BUILDER_H_
#define CARTOGRAPHER_SLAM_MAP_BUILDER_H_

#include <map>
#include <memory>
#include <vector>

#include "cartographer/map/map.h"
#include "cartographer/pose_graph/closure.h"
#include "cartographer/pose_graph/pose_graph.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/slam/local_trajectory_builder.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::slam {

// A scan's pose, also of scans that are no nodes: each hangs on the last node before it.
struct ScanPose {
  common::Time time;
  transform::Rigid3d local_from_sensor;
  submap::NodeId node_id;               // the last node up to this scan
  transform::Rigid3d node_from_sensor;  // identity for the node itself
};

// Carries a drive from scans to a Map: feeds the local trajectory builder, and with its nodes and
// submaps the pose graph. Without loop closures the map frame is the local frame.
class MapBuilder {
 public:
  // Neither may be null (CHECKed). The drive becomes the trajectory `trajectory_id`; the pose graph
  // may hold others.
  MapBuilder(std::unique_ptr<LocalTrajectoryBuilder> local_trajectory_builder,
             std::unique_ptr<pose_graph::PoseGraph> pose_graph, const sensor::LabelSet& labels,
             int trajectory_id = 0);

  // Scans must come with increasing time (CHECKed). The first scan must become a node (CHECKed).
  LocalResult AddScan(const sensor::LabeledScan& scan);

  // The way of the scans to come is appended to `trace` (local_trajectory_builder.h), with the pose
  // graph's part as far as it is known at once.
  void TraceTo(ScanTrace* trace);

  // Ends the drive and hands out the map, whose configuration and history are left to the caller.
  // What the last loop closures took is appended to `stage_times`. No other call may follow but
  // those of the const members.
  map::Map Finish(std::vector<common::StageTime>* stage_times);

  int trajectory_id() const { return trajectory_id_; }
  // Whether a closure ties the drive to another trajectory.
  bool IsTied() const { return tied_; }

  // One entry for each scan so far.
  const std::vector<ScanPose>& scan_poses() const { return scan_poses_; }

  // Nodes and submaps as they are placed at the moment; empty after Finish().
  const pose_graph::Graph& graph() const { return pose_graph_->graph(); }

  // What the pose graph found so far.
  const std::vector<pose_graph::Closure>& closures() const { return pose_graph_->closures(); }
  const pose_graph::VerdictCounts& closure_verdicts() const { return pose_graph_->verdicts(); }
  const std::map<submap::NodeId, pose_graph::NodeSearch>& closure_searches() const {
    return pose_graph_->searches();
  }
  const pose_graph::OptimizationReport& last_optimization() const {
    return pose_graph_->last_optimization();
  }

 private:
  void AddNode(LocalResult* result);
  void TraceNode(const submap::NodeId& node_id,
                 const std::vector<common::StageTime>& graph_times) const;

  const std::unique_ptr<LocalTrajectoryBuilder> local_trajectory_builder_;
  const std::unique_ptr<pose_graph::PoseGraph> pose_graph_;
  const sensor::LabelSet labels_;
  const int trajectory_id_;
  ScanTrace* trace_ = nullptr;
  bool tied_ = false;
  int num_nodes_ = 0;
  std::vector<ScanPose> scan_poses_;
};

// Where the map puts each scan: map_from_node * node_from_sensor.
std::vector<transform::Rigid3d> PlaceScans(const map::Map& map,
                                           const std::vector<ScanPose>& scan_poses);

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_MAP_BUILDER_H_
