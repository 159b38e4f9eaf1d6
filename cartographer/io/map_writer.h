// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_WRITER_H_
#define CARTOGRAPHER_IO_MAP_WRITER_H_

#include <string>

#include "absl/status/status.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// Writes a map as a pbstream file (docs/file_formats.md), atomically. The bytes depend on the map
// alone, not on the number of threads. Stock Cartographer opens the file as a 2D map.
//
// Writing quantizes (cloud_proto.h); a map that was read is written byte by byte as it was.
//
// Errors: what the file system says (atomic_file.h); what cannot be stored, by the element's name
// (pose_graph_proto.h, element_proto.h). Whatever is written can be read.
absl::Status WriteMap(const map::Map& map, const Destination& destination);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_WRITER_H_
