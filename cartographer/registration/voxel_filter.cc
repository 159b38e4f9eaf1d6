// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/voxel_filter.h"

#include <utility>

#include "cartographer/registration/voxel_index.h"
#include "glog/logging.h"

namespace cartographer::registration {
namespace {

using sensor::LabeledPointCloud;

// Smaller voxels are not tried: points of a scan are not that close.
constexpr double kSmallestShare = 1. / 1024.;
constexpr double kPrecision = 0.1;

}  // namespace

LabeledPointCloud FilterByVoxel(const LabeledPointCloud& cloud, double voxel_size_m) {
  CHECK_GT(voxel_size_m, 0.);
  VoxelIndex voxels(cloud.size());
  LabeledPointCloud filtered;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const VoxelKey key = KeyOf(VoxelOf(cloud.positions[i].cast<double>(), 1. / voxel_size_m));
    if (voxels.FindOrInsert(key, 0) != VoxelIndex::kNone) continue;
    filtered.Append(cloud, i);
  }
  return filtered;
}

LabeledPointCloud FilterDownTo(const LabeledPointCloud& cloud, int min_points,
                               double max_voxel_size_m) {
  const size_t enough = static_cast<size_t>(min_points);
  if (cloud.size() <= enough) return cloud;
  LabeledPointCloud filtered = FilterByVoxel(cloud, max_voxel_size_m);
  double too_large_m = max_voxel_size_m, fits_m = max_voxel_size_m;
  while (filtered.size() < enough) {
    too_large_m = fits_m;
    fits_m /= 2.;
    if (fits_m < kSmallestShare * max_voxel_size_m) return cloud;
    filtered = FilterByVoxel(cloud, fits_m);
  }
  while (too_large_m - fits_m > kPrecision * fits_m) {
    const double middle_m = (too_large_m + fits_m) / 2.;
    LabeledPointCloud candidate = FilterByVoxel(cloud, middle_m);
    if (candidate.size() >= enough) {
      fits_m = middle_m;
      filtered = std::move(candidate);
    } else {
      too_large_m = middle_m;
    }
  }
  return filtered;
}

}  // namespace cartographer::registration
