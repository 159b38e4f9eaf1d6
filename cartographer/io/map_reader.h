// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_READER_H_
#define CARTOGRAPHER_IO_MAP_READER_H_

#include <string>

#include "absl/status/statusor.h"
#include "cartographer/io/element_proto.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// Reads a pbstream file (docs/file_formats.md): a map of ours, or a 2D map of Cartographer, whose
// submaps and clouds then are unlabeled and whose records of raw sensor data, landmarks and
// calibration are passed over. Nothing in the file is trusted (map_stream.h, record_reader.h):
// errors name file, record, offset and element.
absl::StatusOr<map::Map> ReadMap(const std::string& path);

// Reads some parts of a map alone, in less time and memory: what is not among them is empty. Nodes,
// with their poses in the map and times, are there in any case, though local_from_node is the
// identity without their clouds; submaps are there if any part of theirs is.
absl::StatusOr<map::Map> ReadMapParts(const std::string& path, const MapParts& parts);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_READER_H_
