// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_MERGE_MAPS_H_
#define CARTOGRAPHER_SLAM_MERGE_MAPS_H_

#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/map/map.h"
#include "cartographer/pose_graph/pose_graph.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::slam {

struct MergedMap {
  map::Map map;
  std::vector<pose_graph::Closure> closures;  // between the two
  pose_graph::VerdictCounts verdicts;
  std::vector<common::StageTime> stage_times;
};

// Joins two maps, with labels of `labels` or none, that show some place both: closures are searched
// for between the nodes of the second and the submaps of the first, and all poses are brought into
// agreement. The frame is the first map's; the second's trajectories get numbers after the first's.
// Both need their nodes' clouds. `pose_graph` is empty.
//
// FailedPrecondition if nothing joins them.
absl::StatusOr<MergedMap> MergeMaps(const map::Map& first, map::Map second,
                                    const sensor::LabelSet& labels,
                                    std::unique_ptr<pose_graph::PoseGraph> pose_graph);

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_MERGE_MAPS_H_
