// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_LOCAL_TRAJECTORY_BUILDER_H_
#define CARTOGRAPHER_SLAM_LOCAL_TRAJECTORY_BUILDER_H_

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cartographer/common/stopwatch.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/slam/scan_trace.h"
#include "cartographer/submap/submap.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::slam {

// What one scan became. `local` is the frame of the odometry: smooth, but it drifts.
struct LocalResult {
  common::Time time;
  transform::Rigid3d local_from_sensor;
  // How the scan was placed: a word of the builder's own, for example "converged"; counted in
  // reports.
  std::string outcome;

  // A node: the scan went into submaps. Absent if the scan could not be placed, or if the motion
  // filter held it back. The first scan of a drive must become one.
  struct Insertion {
    std::shared_ptr<const sensor::LabeledPointCloud> cloud;  // sub-sampled, sensor frame
    // Submaps that took the scan, oldest first, by their index within the trajectory. A submap is
    // shared and still grows until it is `finished`.
    std::map<int, std::shared_ptr<const submap::Submap>> submaps;
  };
  std::optional<Insertion> insertion;

  // What the builder's stages took, in their order.
  std::vector<common::StageTime> stage_times;
};

// Turns the scans of one drive into poses, nodes and submaps: the seat of an odometry in the
// framework. Implementations register under their Lua name (local_trajectory_builder_registry.h).
// Calls come from one thread; implementations may use more inside, but their results must not
// depend on how many.
class LocalTrajectoryBuilder {
 public:
  virtual ~LocalTrajectoryBuilder() = default;

  // Scans must come with increasing time. A hard scan (empty, without overlap, ...) is not an
  // error: the pose is then a prediction and `outcome` says so.
  virtual LocalResult AddScan(const sensor::LabeledScan& scan) = 0;

  // Ends the drive: finishes the submaps that still grow. No AddScan() may follow.
  virtual void Finish() = 0;

  // The way of the scans to come is appended to `trace`, which must outlive them; nullptr, as in
  // the beginning: of none. Results do not depend on it.
  void TraceTo(ScanTrace* trace) { trace_ = trace; }

 protected:
  ScanTrace* trace() const { return trace_; }

 private:
  ScanTrace* trace_ = nullptr;
};

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_LOCAL_TRAJECTORY_BUILDER_H_
