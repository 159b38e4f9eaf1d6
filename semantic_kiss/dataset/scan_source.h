// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_SCAN_SOURCE_H_
#define SEMANTIC_KISS_DATASET_SCAN_SOURCE_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss::dataset {

// How many points carried each id that the label set does not list.
using UnknownLabelIds = std::map<uint16_t, int64_t>;

// The scans of one drive, in order of time, with what is known about the drive as a whole. Says
// nothing about where they come from.
//
// Calls of Read() must not overlap each other or unknown_label_ids(); all else is constant.
class ScanSource {
 public:
  virtual ~ScanSource() = default;

  // Number of scans, >= 0.
  virtual int size() const = 0;

  // The scan at `index`, 0 <= index < size() (CHECKed). Times increase strictly with the index.
  // Values are handed on as they are: points may be NaN or infinite, a scan may be empty. Fails if
  // the scan cannot be read or its parts contradict each other; other scans remain readable.
  virtual absl::StatusOr<cartographer::sensor::LabeledScan> Read(int index) = 0;

  // The set that the labels of the scans belong to.
  virtual const cartographer::sensor::LabelSet& labels() const = 0;

  // True poses of the sensor, truth_from_sensor, one for each scan; nullopt where unknown. They are
  // not normalized: the frame is whatever the data set chose (for KITTI, and if scan 0 is the
  // first, the sensor's frame at scan 0).
  virtual const std::optional<std::vector<cartographer::transform::Rigid3d>>& ground_truth()
      const = 0;

  // Pose of the lidar in the frame of the camera in which the data set states its poses; nullopt
  // where there is no camera.
  virtual const std::optional<cartographer::transform::Rigid3d>& camera_from_sensor() const = 0;

  // Sums over all scans that Read() has returned so far (a scan that is read twice counts twice).
  // These points came as kUnlabeled.
  virtual const UnknownLabelIds& unknown_label_ids() const = 0;

  // What a user should know about how the data was taken, a sentence each: for example that times
  // were assumed. Complete from the start.
  virtual const std::vector<std::string>& notes() const = 0;
};

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_SCAN_SOURCE_H_
