// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_IMAGE_H_
#define CARTOGRAPHER_IO_MAP_IMAGE_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/io/proto/render_options.pb.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// The map from above in its label set's colours, as the bytes of a PNG file: the submaps' grids
// summed (semantic_raster.h), gaps between the lidar's rings filled (raster_gaps.h), shadows of
// what stands above the ground (raster_shadow.h), then trajectories, loop closures and, around the
// map, title, legend, scale bar and axes.
//
// The same map and options give the same bytes on any number of threads; the installed fonts show
// in the text alone. Errors: a map with nothing to draw, a submap's pose that is not finite, a name
// in `hide` or `show` that the label set does not know, no memory for a picture of this size.
absl::StatusOr<std::string> RenderMapImage(const map::Map& map,
                                           const proto::RenderOptions& options);

// The same, written to a file atomically.
absl::Status WriteMapImage(const map::Map& map, const proto::RenderOptions& options,
                           const std::string& path);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_IMAGE_H_
