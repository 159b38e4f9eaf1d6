// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_POSE_GRAPH_STREET_DRIVE_H_
#define TEST_CARTOGRAPHER_POSE_GRAPH_STREET_DRIVE_H_

#include <functional>
#include <memory>
#include <vector>

#include "cartographer/pose_graph/pose_graph.h"
#include "cartographer/submap/active_submaps.h"
#include "test/cartographer/pose_graph/street_scene.h"
#include "test/cartographer/scan_matching/small_scenes.h"

namespace cartographer::pose_graph {

inline submap::proto::SubmapOptions SmallSubmaps() {
  submap::proto::SubmapOptions options;
  options.set_scans_per_submap(12);
  options.set_resolution_m(0.2);
  options.mutable_cloud()->set_voxel_size_m(1.);
  options.mutable_cloud()->set_max_points_per_voxel(20);
  options.mutable_cloud()->set_max_critical_points_per_voxel(20);
  return options;
}

struct StreetDrive {
  int trajectory_id;
  std::vector<transform::Rigid3d> truth;                            // a node each
  std::vector<transform::Rigid3d> local;                            // as the odometry has them
  std::function<bool(int node)> blind = [](int) { return false; };  // where nothing is seen
  int first_visit = 0;                                              // seed of the first node's view
};

// Feeds what the nodes see of the made-up street to the graph; all submaps are finished in the end.
inline void DriveOnStreet(const StreetDrive& drive, PoseGraph* graph) {
  static const auto& street = *new std::vector<ScenePoint>(MakeStreet({}));
  submap::ActiveSubmaps submaps(SmallSubmaps(), scan_matching::SmallLabelSet());
  std::vector<common::StageTime> times;
  for (int i = 0; i < static_cast<int>(drive.truth.size()); ++i) {
    auto cloud = std::make_shared<sensor::LabeledPointCloud>();
    if (!drive.blind(i)) {
      *cloud = SeeFrom(street, drive.truth[i], {drive.first_visit + i, /*share=*/0.1});
    }
    graph->AddNode({drive.trajectory_id, i},
                   {common::FromUnixSeconds(0.1 * i), {}, drive.local[i], cloud},
                   submaps.AddScan(*cloud, *cloud, drive.local[i]), &times);
  }
  submaps.FinishAll();
}

}  // namespace cartographer::pose_graph

#endif  // TEST_CARTOGRAPHER_POSE_GRAPH_STREET_DRIVE_H_
