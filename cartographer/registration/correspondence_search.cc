// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/correspondence_search.h"

#include <cmath>

namespace cartographer::registration {
namespace {

// The map's distances are floats; what they promise is trusted less this much [m].
constexpr double kRoundOff = 1e-5;

}  // namespace

void CorrespondenceSearch::Search(const Eigen::Vector3d& query, sensor::Label label,
                                  Memory* memory) const {
  if (agreeing_factor_ != 1.) return SearchPreferred(query, label, memory);
  const LabeledVoxelMap::Nearest nearest = map_.FindNearest(query, max_distance_m_);
  memory->query = query;
  memory->voxel = map_.VoxelAt(query);
  memory->neighbor = nearest.neighbor;
  const double others_beyond_m = nearest.others_beyond_m - kRoundOff;
  if (nearest.neighbor.has_value()) {
    const double distance = (nearest.neighbor->position - query).norm();
    memory->free_motion_m = (others_beyond_m - distance) / 2.;
  } else {
    memory->free_motion_m = others_beyond_m - max_distance_m_;
  }
}

// Weighted distances are distances times at most 1, so that they change no faster than the query
// moves: what holds for distances holds for them.
void CorrespondenceSearch::SearchPreferred(const Eigen::Vector3d& query, sensor::Label label,
                                           Memory* memory) const {
  const LabeledVoxelMap::Nearest nearest = map_.FindPreferred(query, label, agreeing_factor_);
  memory->query = query;
  memory->voxel = map_.VoxelAt(query);
  memory->neighbor = nearest.neighbor;
  memory->free_motion_m = nearest.others_beyond_m - kRoundOff;
  if (!nearest.neighbor.has_value()) return;
  const double distance = (nearest.neighbor->position - query).norm();
  const bool agrees = sensor::LabelsAgree(label, nearest.neighbor->label);
  memory->free_motion_m -= distance * (agrees ? std::sqrt(agreeing_factor_) : 1.);
  memory->free_motion_m /= 2.;
}

}  // namespace cartographer::registration
