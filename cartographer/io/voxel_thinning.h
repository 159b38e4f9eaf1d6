// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_VOXEL_THINNING_H_
#define CARTOGRAPHER_IO_VOXEL_THINNING_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "cartographer/io/map_point.h"
#include "cartographer/registration/voxel.h"
#include "cartographer/sensor/label.h"

namespace cartographer::io {

// Makes one point of all points in a cube: of the label that most of them have (the smaller label
// on ties; kUnlabeled only where there is no other), at the mean position of the points with that
// label, with the mean of their certainties and intensities. So what overlapping submaps or
// several visits saw stands there once, and lone wrong labels vanish.
//
// Memory grows with the points that come out, not with those that go in.
class VoxelThinning {
 public:
  // `side_m` of a cube, > 0 (CHECKed).
  explicit VoxelThinning(double side_m);

  // Adds a point; its position is given apart, as only offsets from the cube's corner are precise
  // enough as floats. An error if it is not finite or over 2^20 cubes from the origin.
  absl::Status Add(const Eigen::Vector3d& position_m, const MapPoint& point);

  // The points that came out so far, in the order in which their cubes were first hit.
  size_t size() const { return cubes_.size(); }
  MapPoint At(size_t index) const;

 private:
  // The points of one label in a cube.
  struct Entry {
    Eigen::Vector3f offset_sum = Eigen::Vector3f::Zero();  // from the cube's corner [m]
    float certainty_sum = 0.f;
    float intensity_sum = 0.f;
    uint32_t count = 0;
    uint32_t next;  // of the same cube, kNone: this is the last
    sensor::Label label;
  };
  static constexpr uint32_t kNone = 0xffffffff;

  // The entry of that label in the cube whose first entry is `first`; a new one if it has none.
  Entry& EntryOf(uint32_t first, sensor::Label label);
  uint32_t NewEntry(sensor::Label label);
  const Entry& MostSeen(uint32_t first) const;

  const double side_m_;
  absl::flat_hash_map<registration::VoxelKey, uint32_t> first_entry_of_cube_;
  std::vector<Entry> entries_;
  struct Cube {
    Eigen::Vector3i coordinates;
    uint32_t first_entry;
  };
  std::vector<Cube> cubes_;  // in the order of their first points
};

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_VOXEL_THINNING_H_
