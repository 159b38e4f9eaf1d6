// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/voxel_thinning.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "glog/logging.h"

namespace cartographer::io {

using registration::VoxelCoordinates;

VoxelThinning::VoxelThinning(double side_m) : side_m_(side_m) { CHECK_GT(side_m, 0.); }

absl::Status VoxelThinning::Add(const Eigen::Vector3d& position_m, const MapPoint& point) {
  constexpr double kMaxCubes = 1 << 20;
  if (!(position_m.cwiseAbs().maxCoeff() < kMaxCubes * side_m_)) {
    return absl::OutOfRangeError(
        absl::StrCat("a point at (", position_m.x(), ", ", position_m.y(), ", ", position_m.z(),
                     ") m is too far away for cubes of ", side_m_, " m; choose larger ones"));
  }
  const VoxelCoordinates cube = registration::VoxelOf(position_m, 1. / side_m_);
  const auto [it, is_new] = first_entry_of_cube_.try_emplace(registration::KeyOf(cube), kNone);
  if (is_new) {
    it->second = NewEntry(point.label);
    cubes_.push_back({cube.matrix(), it->second});
  }
  Entry& entry = EntryOf(it->second, point.label);
  const Eigen::Vector3d corner = side_m_ * cube.cast<double>().matrix();
  entry.offset_sum += (position_m - corner).cast<float>();
  entry.certainty_sum += point.certainty;
  entry.intensity_sum += point.intensity;
  ++entry.count;
  return absl::OkStatus();
}

uint32_t VoxelThinning::NewEntry(sensor::Label label) {
  Entry entry;
  entry.label = label;
  entry.next = kNone;
  CHECK_LT(entries_.size(), kNone);
  entries_.push_back(entry);
  return static_cast<uint32_t>(entries_.size() - 1);
}

VoxelThinning::Entry& VoxelThinning::EntryOf(uint32_t first, sensor::Label label) {
  uint32_t last = first;
  for (uint32_t i = first; i != kNone; i = entries_[i].next) {
    if (entries_[i].label == label) return entries_[i];
    last = i;
  }
  const uint32_t added = NewEntry(label);
  entries_[last].next = added;
  return entries_[added];
}

const VoxelThinning::Entry& VoxelThinning::MostSeen(uint32_t first) const {
  const Entry* best = &entries_[first];
  for (uint32_t i = best->next; i != kNone; i = entries_[i].next) {
    const Entry& other = entries_[i];
    const bool best_says_nothing = best->label == sensor::kUnlabeled;
    const bool other_says_nothing = other.label == sensor::kUnlabeled;
    const bool beats =
        best_says_nothing != other_says_nothing
            ? best_says_nothing
            : std::make_pair(other.count, best->label) > std::make_pair(best->count, other.label);
    if (beats) best = &other;
  }
  return *best;
}

MapPoint VoxelThinning::At(size_t index) const {
  const Cube& cube = cubes_[index];
  const Entry& entry = MostSeen(cube.first_entry);
  const auto count = static_cast<float>(entry.count);
  const Eigen::Vector3d corner = side_m_ * cube.coordinates.cast<double>();
  const Eigen::Vector3d position = corner + (entry.offset_sum / count).cast<double>();
  return {position.cast<float>(), entry.certainty_sum / count, entry.intensity_sum / count,
          entry.label};
}

}  // namespace cartographer::io
