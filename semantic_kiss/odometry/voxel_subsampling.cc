// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/voxel_subsampling.h"

#include <array>
#include <vector>

#include "cartographer/common/parallel.h"
#include "cartographer/registration/voxel.h"
#include "cartographer/registration/voxel_index.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::registration::VoxelCoordinates;
using cartographer::registration::VoxelIndex;
using cartographer::registration::VoxelKey;
using cartographer::registration::VoxelOf;
using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabelMask;

struct Occupancy {
  int ordinary = 0;
  int critical = 0;
};

// Whether a voxel has room for one more point; counts it if so.
bool Admit(const proto::SubsamplingOptions& options, bool is_critical, Occupancy* occupancy) {
  if (occupancy->ordinary < options.max_points_per_voxel()) {
    ++occupancy->ordinary;
    return true;
  }
  if (is_critical && occupancy->critical < options.max_critical_points_per_voxel()) {
    ++occupancy->critical;
    return true;
  }
  return false;
}

// Scans thin out by about this factor; only the first guess of the tables' sizes hangs on it.
constexpr size_t kExpectedReduction = 4;

// Feeds the points of `cloud` that `indices(i)` names, i = 0 .. size - 1 and ascending, through the
// voxels.
template <typename IndexOf>
std::vector<uint32_t> Thin(const LabeledPointCloud& cloud, size_t size, const IndexOf& index_of,
                           const proto::SubsamplingOptions& options, const LabelMask& critical) {
  const double inverse_voxel_size = 1. / options.voxel_size_m();
  VoxelIndex index(size / kExpectedReduction);
  std::vector<Occupancy> voxels;
  std::vector<uint32_t> admitted;

  // Neighbours in a scan mostly share a voxel, which saves the look-up.
  VoxelKey last_key = 0;
  uint32_t last_voxel = VoxelIndex::kNone;
  for (size_t i = 0; i < size; ++i) {
    const uint32_t point = index_of(i);
    const VoxelKey key = cartographer::registration::KeyOf(
        VoxelOf(cloud.positions[point].cast<double>(), inverse_voxel_size));
    if (key != last_key || last_voxel == VoxelIndex::kNone) {
      last_key = key;
      last_voxel = index.FindOrInsert(key, static_cast<uint32_t>(voxels.size()));
      if (last_voxel == VoxelIndex::kNone) {
        last_voxel = static_cast<uint32_t>(voxels.size());
        voxels.emplace_back();
      }
    }
    if (Admit(options, critical.Contains(cloud.labels[point]), &voxels[last_voxel])) {
      admitted.push_back(point);
    }
  }
  return admitted;
}

// Chunks are thinned on their own and in parallel, then once more together. The result is that of
// one pass: what a chunk turns away comes after points that fill its voxel in the one pass, too.
constexpr size_t kPointsPerChunk = 16384;

std::vector<uint32_t> ThinInParallel(const LabeledPointCloud& cloud,
                                     const proto::SubsamplingOptions& options,
                                     const LabelMask& critical) {
  std::vector<uint32_t> candidates;
  for (const std::vector<uint32_t>&chunk :
       cartographer::common::ParallelMapChunks<std::vector<uint32_t>>(
           cloud.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
             return Thin(
                 cloud, end - begin, [begin](size_t i) { return static_cast<uint32_t>(begin + i); },
                 options, critical);
           })) {
    candidates.insert(candidates.end(), chunk.begin(), chunk.end());
  }
  if (cloud.size() <= kPointsPerChunk) return candidates;
  return Thin(
      cloud, candidates.size(), [&](size_t i) { return candidates[i]; }, options, critical);
}

// The spatial hash of Teschner et al. (2003), with the constants of KISS-ICP.
uint32_t SpatialHash(const VoxelCoordinates& voxel) {
  return static_cast<uint32_t>(voxel.x()) * 73856093u ^
         static_cast<uint32_t>(voxel.y()) * 19349669u ^
         static_cast<uint32_t>(voxel.z()) * 83492791u;
}

// Sorts `values` by `keys` (each below `num_keys`), stably and in linear time: a radix sort by 11
// bits at a time.
std::vector<uint32_t> StableOrder(std::vector<uint32_t> keys, uint32_t num_keys,
                                  std::vector<uint32_t> values) {
  constexpr int kBits = 11;
  std::vector<uint32_t> sorted_keys(keys.size()), sorted_values(values.size());
  for (int shift = 0; shift < 32 && (num_keys - 1) >> shift != 0; shift += kBits) {
    std::array<uint32_t, (1 << kBits) + 1> starts{};
    const auto digit = [&](size_t i) { return keys[i] >> shift & ((1 << kBits) - 1); };
    for (size_t i = 0; i < keys.size(); ++i) ++starts[digit(i) + 1];
    for (size_t d = 1; d < starts.size(); ++d) starts[d] += starts[d - 1];
    for (size_t i = 0; i < keys.size(); ++i) {
      const uint32_t place = starts[digit(i)]++;
      sorted_keys[place] = keys[i];
      sorted_values[place] = values[i];
    }
    keys.swap(sorted_keys);
    values.swap(sorted_values);
  }
  return values;
}

// Orders points by the bucket that their voxel has in a hash table for the whole cloud.
std::vector<uint32_t> OrderByHash(const LabeledPointCloud& cloud, double voxel_size_m,
                                  const std::vector<uint32_t>& points) {
  uint32_t num_buckets = 1;
  while (num_buckets < 2 * cloud.size()) num_buckets *= 2;
  std::vector<uint32_t> buckets(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    buckets[i] =
        SpatialHash(VoxelOf(cloud.positions[points[i]].cast<double>(), 1. / voxel_size_m)) &
        (num_buckets - 1);
  }
  return StableOrder(buckets, num_buckets, points);
}

}  // namespace

LabeledPointCloud Subsample(const LabeledPointCloud& cloud,
                            const proto::SubsamplingOptions& options, const LabelMask& critical) {
  LabeledPointCloud result;
  const std::vector<uint32_t> points =
      OrderByHash(cloud, options.voxel_size_m(), ThinInParallel(cloud, options, critical));
  result.Reserve(points.size());
  for (const uint32_t point : points) {
    result.positions.push_back(cloud.positions[point]);
    result.labels.push_back(cloud.labels[point]);
    result.certainties.push_back(cloud.certainties[point]);
  }
  return result;
}

}  // namespace semantic_kiss::odometry
