// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_READER_H_
#define CARTOGRAPHER_IO_MAP_READER_H_

#include <string>

#include "absl/status/statusor.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// Reads a pbstream file (docs/file_formats.md): a map of ours, or a 2D map of Cartographer, whose
// submaps and clouds then are unlabeled and whose records of raw sensor data, landmarks and
// calibration are passed over. Nothing in the file is trusted (map_stream.h, record_reader.h):
// errors name file, record, offset and element.
absl::StatusOr<map::Map> ReadMap(const std::string& path);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_READER_H_
