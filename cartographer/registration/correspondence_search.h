// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_REGISTRATION_CORRESPONDENCE_SEARCH_H_
#define CARTOGRAPHER_REGISTRATION_CORRESPONDENCE_SEARCH_H_

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "cartographer/registration/labeled_voxel_map.h"

namespace cartographer::registration {

// Nearest neighbours for a cloud that moves a little at a time, as in ICP. Each search also tells
// how far every other point is, so as long as a query has moved less than half of the difference
// its neighbour is still the nearest and need not be searched again. The answers are those of the
// map, only most of them come for free: after a few iterations of ICP nearly all.
class CorrespondenceSearch {
 public:
  // With an `agreeing_factor` of 1 neighbours are those of FindNearest(), else those of
  // FindPreferred(). The map must outlive this object and must not change.
  CorrespondenceSearch(const LabeledVoxelMap& map, double max_distance_m, double agreeing_factor,
                       size_t num_points)
      : map_(map),
        max_distance_m_(max_distance_m),
        agreeing_factor_(agreeing_factor),
        memory_(num_points) {}

  // The map's point nearest to point `index` of the cloud, which has `label` and is now at `query`;
  // nullopt if that is not nearer than `max_distance_m`. May be called in parallel for different
  // points.
  std::optional<LabeledVoxelMap::Neighbor> Find(size_t index, const Eigen::Vector3d& query,
                                                sensor::Label label) {
    Memory& memory = memory_[index];
    if (!StillHolds(memory, query)) Search(query, label, &memory);
    if (!memory.neighbor.has_value() ||
        (memory.neighbor->position - query).squaredNorm() >= max_distance_m_ * max_distance_m_) {
      return std::nullopt;
    }
    return memory.neighbor;
  }

 private:
  // What the last search for a point found.
  struct Memory {
    Eigen::Vector3d query = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
    VoxelCoordinates voxel;
    // How far the query may move before another point can be the nearest; negative: not at all.
    double free_motion_m = -1.;
    std::optional<LabeledVoxelMap::Neighbor> neighbor;
  };

  // A search sees the 27 voxels around the query, so its answer ends with the query's voxel.
  bool StillHolds(const Memory& memory, const Eigen::Vector3d& query) const {
    return memory.free_motion_m > 0. &&
           (query - memory.query).squaredNorm() < memory.free_motion_m * memory.free_motion_m &&
           (map_.VoxelAt(query) == memory.voxel).all();
  }
  void Search(const Eigen::Vector3d& query, sensor::Label label, Memory* memory) const;
  void SearchPreferred(const Eigen::Vector3d& query, sensor::Label label, Memory* memory) const;

  const LabeledVoxelMap& map_;
  const double max_distance_m_;
  const double agreeing_factor_;
  std::vector<Memory> memory_;
};

}  // namespace cartographer::registration

#endif  // CARTOGRAPHER_REGISTRATION_CORRESPONDENCE_SEARCH_H_
