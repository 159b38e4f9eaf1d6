// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_OCCUPANCY_GRID_H_
#define CARTOGRAPHER_IO_OCCUPANCY_GRID_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/io/proto/render_options.pb.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// A map for robots that plan in the plane, as the map_server of ROS loads it.
struct OccupancyGrid {
  // A PGM file (binary, P5), a byte a pixel: 0 where what stands there was seen most, 254 where
  // the ground was (gaps between the lidar's rings filled as in pictures), 205 where nothing was.
  std::string pgm;
  // The YAML file that belongs to it: the picture's name, side of a pixel and position of the
  // lower left corner in the map [m], and the thresholds that give back the three values.
  std::string yaml;
};

// Draws what the options show (hidden_labels.h), all of it: `crop_share` does not count here,
// though unlabeled hits that lie beyond all others may be outside. Errors: nothing to draw; unknown
// labels; a resolution of one's own that needs more than `max_side_px` pixels a side.
absl::StatusOr<OccupancyGrid> DrawOccupancyGrid(const map::Map& map,
                                                const proto::RenderOptions& options,
                                                const std::string& pgm_name);

// Writes X.pgm and, beside it, X.yaml, both or neither.
absl::Status WriteOccupancyGrid(const map::Map& map, const proto::RenderOptions& options,
                                const std::string& pgm_path);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_OCCUPANCY_GRID_H_
