// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_POINT_CLOUD_FILES_H_
#define CARTOGRAPHER_IO_POINT_CLOUD_FILES_H_

#include <string>

#include "absl/status/status.h"
#include "cartographer/io/map_cloud.h"

namespace cartographer::io {

// Point clouds as files of other programs, binary, little-endian, written atomically. A point has
// x y z [m], the colour of its label, the label's number in its data set's files (comments in the
// header name those that occur), certainty and, if all points have one, intensity, both in [0, 1].

// Stanford's PLY: float x y z, uchar red green blue, ushort label, float certainty intensity.
absl::Status WritePly(const MapCloud& cloud, const std::string& path);

// PCD of the Point Cloud Library, version 0.7: 4 bytes a field; rgb packed as 0x00RRGGBB in what is
// declared a float, as that library wants it, label unsigned, the others float.
absl::Status WritePcd(const MapCloud& cloud, const std::string& path);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_POINT_CLOUD_FILES_H_
