// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LOCAL_TRAJECTORY_BUILDER_H_
#define SEMANTIC_KISS_LOCAL_TRAJECTORY_BUILDER_H_

#include "cartographer/sensor/label_set.h"
#include "cartographer/slam/local_trajectory_builder.h"
#include "cartographer/slam/local_trajectory_builder_registry.h"
#include "cartographer/slam/motion_filter.h"
#include "cartographer/submap/active_submaps.h"
#include "semantic_kiss/odometry/odometry.h"
#include "semantic_kiss/proto/semantic_kiss_options.pb.h"

namespace semantic_kiss {

// The plugin: semantic KISS-ICP as a local trajectory builder. The one place where the odometry and
// the framework meet. A scan that could not be placed becomes no node; where the odometry begins
// anew, so do the submaps (docs/decisions/0006).
class LocalTrajectoryBuilder : public cartographer::slam::LocalTrajectoryBuilder {
 public:
  LocalTrajectoryBuilder(const proto::SemanticKissOptions& options,
                         const cartographer::sensor::LabelSet& labels);

  cartographer::slam::LocalResult AddScan(const cartographer::sensor::LabeledScan& scan) override;
  void Finish() override;

 private:
  // Makes a node of the scan.
  void Insert(const odometry::OdometryReport& report, cartographer::slam::LocalResult* result);
  void Trace(const cartographer::sensor::LabeledPointCloud& scan,
             const odometry::OdometryReport& report,
             const cartographer::slam::LocalResult& result) const;

  // Maps never hold what moves, whatever the odometry makes of it.
  const cartographer::sensor::LabelMask moving_labels_;
  const odometry::proto::OdometryOptions odometry_options_;
  odometry::Odometry odometry_;
  cartographer::slam::MotionFilter motion_filter_;
  cartographer::submap::ActiveSubmaps active_submaps_;
};

// Makes it known as "semantic_kiss", with options of type proto::SemanticKissOptions.
void RegisterLocalTrajectoryBuilder(cartographer::slam::LocalTrajectoryBuilderRegistry* registry);

}  // namespace semantic_kiss

#endif  // SEMANTIC_KISS_LOCAL_TRAJECTORY_BUILDER_H_
