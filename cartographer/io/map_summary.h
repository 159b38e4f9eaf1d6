// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_SUMMARY_H_
#define CARTOGRAPHER_IO_MAP_SUMMARY_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/time.h"
#include "cartographer/map/label_count.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::io {

// What is in a map file, found in one pass that keeps no more than a few records in memory.
struct MapSummary {
  // The records of one kind.
  struct Kind {
    std::string name;  // "header", "pose_graph", "submap", ...: as the messages' fields are called
    int64_t count = 0;
    uint64_t stored_bytes = 0;   // in the file
    uint64_t message_bytes = 0;  // decompressed
  };
  struct Trajectory {
    int id = 0;
    int64_t num_nodes = 0;
    int64_t num_submaps = 0;
    common::Time first_time, last_time;  // of nodes, if there are any
    double length_m = 0.;                // along the nodes' poses in the map
  };
  uint64_t file_bytes = 0;
  int format_version = 0;
  bool made_by_us = false;  // if not, labels, configuration and history are empty
  std::vector<Kind> kinds;  // in the order of their first records
  std::vector<Trajectory> trajectories;
  int64_t num_intra_constraints = 0;
  int64_t num_inter_constraints = 0;
  // Submaps that are not 2D grids of probabilities: such a map can be summed up, not opened.
  int64_t num_unsupported_submaps = 0;
  sensor::LabelSet labels;
  map::LabelCounts label_counts;
  Eigen::AlignedBox3d node_bounds_m;  // of the nodes' positions, in the map frame
  Eigen::AlignedBox2d grid_bounds_m;  // of the tiles of all submaps' grids, in the map frame
  std::string configuration_lua;
  std::vector<std::string> history;
};

// Also for maps of Cartographer. Errors are those of MapStream.
absl::StatusOr<MapSummary> ReadMapSummary(const std::string& path);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_SUMMARY_H_
