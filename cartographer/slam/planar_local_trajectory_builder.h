// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_PLANAR_LOCAL_TRAJECTORY_BUILDER_H_
#define CARTOGRAPHER_SLAM_PLANAR_LOCAL_TRAJECTORY_BUILDER_H_

#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/slam/local_trajectory_builder.h"
#include "cartographer/slam/local_trajectory_builder_registry.h"
#include "cartographer/slam/motion_filter.h"
#include "cartographer/slam/planar_motion.h"
#include "cartographer/slam/proto/planar_builder_options.pb.h"
#include "cartographer/submap/active_planar_submaps.h"

namespace cartographer::slam {

// Cartographer's way in the plane: of each scan a band of heights without the ground, matched with
// the older of two growing grids of probabilities, from where constant velocity expects it; nodes
// go into both. Poses are level and have height 0; labels decide nothing. Scans are taken as they
// are: deskewed, and by a sensor that is mounted level.
//
// Outcomes: "first", of every scan until one has shown something; "matched"; "too_few_points" and
// "no_fit", where the scan is placed as expected and not mapped.
// Source: Hess et al., "Real-Time Loop Closure in 2D LIDAR SLAM", ICRA 2016, section IV.
class PlanarLocalTrajectoryBuilder : public LocalTrajectoryBuilder {
 public:
  PlanarLocalTrajectoryBuilder(const proto::PlanarBuilderOptions& options,
                               const sensor::LabelSet& labels);

  LocalResult AddScan(const sensor::LabeledScan& scan) override;
  void Finish() override;

 private:
  void Trace(const sensor::LabeledPointCloud& scan, const sensor::LabeledPointCloud& band,
             const sensor::LabeledPointCloud& matched_points, const LocalResult& result) const;
  // Places `result`, and says how.
  void Match(const sensor::LabeledPointCloud& matched_points, LocalResult* result) const;
  void Insert(const sensor::LabeledPointCloud& band,
              const sensor::LabeledPointCloud& matched_points, LocalResult* result);

  const proto::PlanarBuilderOptions options_;
  const sensor::LabelMask moving_labels_;
  PlanarMotion motion_;
  MotionFilter motion_filter_;
  submap::ActivePlanarSubmaps active_submaps_;
};

// Makes it known as "planar", with options of type proto::PlanarBuilderOptions.
void RegisterPlanarLocalTrajectoryBuilder(LocalTrajectoryBuilderRegistry* registry);

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_PLANAR_LOCAL_TRAJECTORY_BUILDER_H_
