// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_SEMANTIC_GRID_PROTO_H_
#define CARTOGRAPHER_IO_SEMANTIC_GRID_PROTO_H_

#include <cstddef>

#include "absl/status/statusor.h"
#include "cartographer/map/proto/semantic_map.pb.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::io {

// 256 MiB of tiles: what one submap may take at most when a file is read.
inline constexpr size_t kMaxTiles = size_t{1} << 19;

// The multi-layer grid as maps hold it, loss-free: see SemanticGrid in semantic_map.proto.

// Tiles farther than 2^26 tiles from the origin cannot be stored, nor labels not below
// `num_labels`, nor over 2^19 tiles.
absl::StatusOr<map::proto::SemanticGrid> ToProto(const submap::SemanticGrid& grid,
                                                 size_t num_labels);

// Errors name the layer: besides the above, layers and tiles out of order or twice, sizes that do
// not match, counts of hits outside [1, 65535], a resolution outside [1e-3, 1e3] m.
absl::StatusOr<submap::SemanticGrid> FromProto(const map::proto::SemanticGrid& proto,
                                               size_t num_labels);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_SEMANTIC_GRID_PROTO_H_
