// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_REGISTRATION_VOXEL_H_
#define CARTOGRAPHER_REGISTRATION_VOXEL_H_

#include <Eigen/Core>
#include <cstdint>

namespace cartographer::registration {

// Integer coordinates of a voxel: voxel i covers [i, i + 1) * size along each axis, also below
// zero.
using VoxelCoordinates = Eigen::Array3i;

// std::floor for numbers that fit an int: a library call without SSE4.1, and this is called for
// every point of every scan.
inline int FloorToInt(double value) {
  const int truncated = static_cast<int>(value);
  return truncated - (value < truncated ? 1 : 0);
}

inline VoxelCoordinates VoxelOf(const Eigen::Vector3d& point, double inverse_size) {
  return {FloorToInt(point.x() * inverse_size), FloorToInt(point.y() * inverse_size),
          FloorToInt(point.z() * inverse_size)};
}

// A voxel as one number, unique within +-2^20 voxels of the origin along each axis (farther ones
// wrap around).
using VoxelKey = uint64_t;

inline VoxelKey KeyOf(const VoxelCoordinates& voxel) {
  constexpr uint64_t kMask = (uint64_t{1} << 21) - 1;
  return (static_cast<uint64_t>(voxel.x()) & kMask) |
         (static_cast<uint64_t>(voxel.y()) & kMask) << 21 |
         (static_cast<uint64_t>(voxel.z()) & kMask) << 42;
}

}  // namespace cartographer::registration

#endif  // CARTOGRAPHER_REGISTRATION_VOXEL_H_
