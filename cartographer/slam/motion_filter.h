// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_MOTION_FILTER_H_
#define CARTOGRAPHER_SLAM_MOTION_FILTER_H_

#include "cartographer/common/time.h"
#include "cartographer/slam/proto/motion_filter_options.pb.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::slam {

// Holds back scans that show nothing new: a standing car needs no nodes.
class MotionFilter {
 public:
  explicit MotionFilter(const proto::MotionFilterOptions& options) : options_(options) {}

  // Whether the scan is to become a node; if so, later scans are compared with it. The first scan
  // always is.
  bool Admit(common::Time time, const transform::Rigid3d& local_from_sensor);

 private:
  const proto::MotionFilterOptions options_;
  bool has_last_ = false;
  common::Time last_time_;
  transform::Rigid3d local_from_last_;
};

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_MOTION_FILTER_H_
