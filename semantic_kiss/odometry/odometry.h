// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_ODOMETRY_H_
#define SEMANTIC_KISS_ODOMETRY_ODOMETRY_H_

#include <vector>

#include "absl/strings/string_view.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/registration/labeled_voxel_map.h"
#include "cartographer/registration/semantic_icp.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/odometry/adaptive_threshold.h"
#include "semantic_kiss/odometry/label_rules.h"
#include "semantic_kiss/odometry/motion_model.h"
#include "semantic_kiss/odometry/preprocessing.h"
#include "semantic_kiss/odometry/proto/odometry_options.pb.h"

namespace semantic_kiss::odometry {

// What one scan became.
struct OdometryReport {
  // Pose of the sensor in the odometry's frame, which is the sensor's frame at the first scan.
  cartographer::transform::Rigid3d local_from_sensor;

  enum class Placement {
    kFirst,       // the local map was empty: placed by the motion model, and began the map
    kRegistered,  // placed by ICP
    kPredicted,   // ICP could not place it (see `icp.outcome`): placed by the motion model, not
                  // mapped
    kRestarted    // the same, and the local map begins anew with it
  };
  Placement placement = Placement::kPredicted;
  cartographer::registration::IcpReport icp;  // default-constructed for kFirst
  // What ICP began with: the predicted pose, and the adaptive threshold's sigma and largest
  // distance of a pair.
  cartographer::transform::Rigid3d local_from_guess;
  double sigma_m = 0.;
  double gate_m = 0.;

  PreprocessingCounts counts;
  cartographer::transform::Twist motion = cartographer::transform::Twist::Zero();  // deskewed by it
  bool deskewed = false;
  // Clouds in the sensor's frame: all usable points, and the sub-samplings of it.
  cartographer::sensor::LabeledPointCloud points;
  cartographer::sensor::LabeledPointCloud points_for_map;
  cartographer::sensor::LabeledPointCloud points_for_icp;

  // Points of the local map: those that the scan added, those that were dropped as far away, and
  // those that are there now.
  size_t map_points_added = 0;
  size_t map_points_dropped = 0;
  size_t map_points = 0;

  // "preprocessing", "subsampling", "registration", "local_map".
  std::vector<cartographer::common::StageTime> stage_times;
};

// One word for reports: "first", the ICP's outcome, or "restarted".
absl::string_view OutcomeName(const OdometryReport& report);

// Semantic KISS-ICP, scan by scan (design.md, section 3). In mode "kiss_icp" it is KISS-ICP: labels
// are carried along but decide nothing. With the options of sage_icp.lua it is SAGE-ICP.
class Odometry {
 public:
  // Names of labels in the options must be known (CHECKed; LabelRules::Create() tells).
  Odometry(const proto::OdometryOptions& options, const cartographer::sensor::LabelSet& labels);

  // Scans in the order of time. Any scan is survived: where it cannot be registered, the motion
  // model carries on.
  OdometryReport AddScan(const cartographer::sensor::LabeledPointCloud& scan);

  const cartographer::registration::LabeledVoxelMap& local_map() const { return local_map_; }

 private:
  void SubsampleScan(OdometryReport* report) const;
  void Register(OdometryReport* report);
  void UpdateLocalMap(OdometryReport* report);

  const proto::OdometryOptions options_;
  const LabelRules rules_;
  cartographer::registration::LabeledVoxelMap local_map_;
  AdaptiveThreshold threshold_;
  MotionModel motion_;
  int failures_in_a_row_ = 0;
};

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_ODOMETRY_H_
