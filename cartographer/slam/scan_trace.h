// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_SCAN_TRACE_H_
#define CARTOGRAPHER_SLAM_SCAN_TRACE_H_

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cartographer/sensor/label.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::slam {

// How many points have each label; labels that none has are not listed.
using PointsByLabel = std::map<sensor::Label, size_t>;

PointsByLabel CountByLabel(const sensor::LabeledPointCloud& cloud);

// What one stage made of one scan, for people who ask where a scan went wrong. Nothing may be
// decided by it.
struct TraceStep {
  std::string stage;    // unique within a trace: "range", "submap 3"
  std::string frame;    // of what goes out: "sensor", "local", "submap", "map"
  std::string outcome;  // in words

  std::string from{};  // the step whose points are taken; empty: none are
  std::optional<size_t> points_in{}, points_out{};
  PointsByLabel labels{};           // of the points that go out; empty: not told
  std::optional<double> seconds{};  // absent: within those of the step before

  // Fill in the columns above. `Gives` a cloud tells its labels as well.
  TraceStep& Takes(const std::string& step, size_t num_points);
  TraceStep& Gives(size_t num_points);
  TraceStep& Gives(const sensor::LabeledPointCloud& cloud);
  TraceStep& Took(double duration_s);
};

// In the order of the way. A stage that works on what is not points (a pose) has no `from`; every
// other one takes as many points as the step that it names gave.
using ScanTrace = std::vector<TraceStep>;

// The step that whoever reads scans writes down; builders take its points.
inline constexpr char kReadingStep[] = "reading";

// "x 12.31, y -0.20, z 0.04 m, yaw 3.1 deg"
std::string PoseText(const transform::Rigid3d& pose);
// "0.12 m, 0.31 deg": how far a motion goes and turns.
std::string MotionText(const transform::Rigid3d& motion);

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_SCAN_TRACE_H_
