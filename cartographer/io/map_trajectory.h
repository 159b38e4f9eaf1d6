// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_TRAJECTORY_H_
#define CARTOGRAPHER_IO_MAP_TRAJECTORY_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/time.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::io {

// The way of the sensor through a map, a pose for every node, in the order of time. Scans that did
// not become nodes, since nothing had moved, are not among them.
struct MapTrajectory {
  std::vector<common::Time> times;
  std::vector<transform::Rigid3d> map_from_sensor;
};

// Reads a trajectory from the beginning of a map file; its submaps and nodes, nearly all of the
// file, are not touched. Without an `id` the map must have one trajectory. Errors: those of
// MapStream::Open(); no such trajectory, more than one, none with a node, by the ids that are
// there.
absl::StatusOr<MapTrajectory> ReadMapTrajectory(const std::string& map_path, std::optional<int> id);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_TRAJECTORY_H_
