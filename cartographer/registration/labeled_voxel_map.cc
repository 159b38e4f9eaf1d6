// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/labeled_voxel_map.h"

#include <algorithm>
#include <array>
#include <limits>

#include "glog/logging.h"

namespace cartographer::registration {
namespace {

// Distances to four points at a time. Compilers vectorize sums but not "smallest and where", hence
// the explicit lanes (a GCC and Clang extension that falls back to scalars elsewhere).
constexpr uint32_t kLanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Ints = int32_t __attribute__((vector_size(16)));

// Where no point is; far enough that it never is the nearest.
constexpr float kNowhere = 1e15f;

Floats Load(const float* values) {
  Floats lanes;
  __builtin_memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

constexpr std::array<int, 3> kNearShiftsFirst = {0, -1, 1};

uint32_t RoundUpToLanes(uint32_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

}  // namespace

// The nearest point so far, by where it is stored.
struct LabeledVoxelMap::Candidate {
  float squared_distance;
  VoxelCoordinates voxel;
  uint32_t block = VoxelIndex::kNone;
  uint32_t slot = 0;
};

LabeledVoxelMap::LabeledVoxelMap(const proto::VoxelMapOptions& options,
                                 const sensor::LabelMask& critical)
    : voxel_size_(options.voxel_size_m()),
      inverse_voxel_size_(1. / options.voxel_size_m()),
      max_ordinary_(options.max_points_per_voxel()),
      max_critical_(options.max_critical_points_per_voxel()),
      min_squared_distance_(
          static_cast<float>(voxel_size_ * voxel_size_ / options.max_points_per_voxel())),
      block_capacity_(RoundUpToLanes(options.max_points_per_voxel())),
      critical_(critical) {
  CHECK_GT(voxel_size_, 0.);
  CHECK_GT(max_ordinary_, 0);
}

void LabeledVoxelMap::Insert(const sensor::LabeledPointCloud& cloud,
                             const transform::Rigid3d& map_from_cloud) {
  const Eigen::Matrix3d rotation = map_from_cloud.rotation().toRotationMatrix();
  for (size_t i = 0; i < cloud.size(); ++i) {
    InsertPoint(rotation * cloud.positions[i].cast<double>() + map_from_cloud.translation(),
                cloud.labels[i], cloud.certainties[i]);
  }
}

void LabeledVoxelMap::InsertPoint(const Eigen::Vector3d& point, sensor::Label label,
                                  float certainty) {
  const VoxelCoordinates coordinates = VoxelOf(point, inverse_voxel_size_);
  const Eigen::Vector3f offset = (point - Corner(coordinates)).cast<float>();
  const uint32_t found =
      index_.FindOrInsert(KeyOf(coordinates), static_cast<uint32_t>(voxels_.size()));
  if (found == VoxelIndex::kNone) {
    Voxel voxel;
    voxel.coordinates = coordinates;
    voxel.first_block = NewBlock();
    voxels_.push_back(voxel);
  }
  Voxel& voxel = found == VoxelIndex::kNone ? voxels_.back() : voxels_[found];
  const bool critical = critical_.Contains(label);
  if (!HasRoom(voxel, offset, critical)) return;
  Append(&voxel, offset, label, certainty);
}

bool LabeledVoxelMap::HasRoom(const Voxel& voxel, const Eigen::Vector3f& offset,
                              bool critical) const {
  if (critical && voxel.num_critical < max_critical_) return true;
  if (voxel.num_ordinary >= max_ordinary_) return false;
  for (uint32_t block = voxel.first_block; block != VoxelIndex::kNone;
       block = blocks_[block].next) {
    const float* const x = Coordinates(block);
    const float* const y = x + block_capacity_;
    const float* const z = y + block_capacity_;
    for (uint32_t i = 0; i < blocks_[block].size; ++i) {
      const float dx = x[i] - offset.x(), dy = y[i] - offset.y(), dz = z[i] - offset.z();
      if (dx * dx + dy * dy + dz * dz < min_squared_distance_) return false;
    }
  }
  return true;
}

void LabeledVoxelMap::Append(Voxel* voxel, const Eigen::Vector3f& offset, sensor::Label label,
                             float certainty) {
  uint32_t block = voxel->first_block;
  while (blocks_[block].size == block_capacity_) {
    if (blocks_[block].next == VoxelIndex::kNone) {
      const uint32_t added = NewBlock();
      blocks_[block].next = added;
    }
    block = blocks_[block].next;
  }
  const uint32_t slot = blocks_[block].size++;
  float* const coordinates = Coordinates(block);
  for (int axis = 0; axis < 3; ++axis) coordinates[axis * block_capacity_ + slot] = offset[axis];
  labels_[size_t{block} * block_capacity_ + slot] = label;
  certainties_[size_t{block} * block_capacity_ + slot] = certainty;
  const bool counts_as_critical = critical_.Contains(label) && voxel->num_critical < max_critical_;
  ++(counts_as_critical ? voxel->num_critical : voxel->num_ordinary);
  ++num_points_;
}

uint32_t LabeledVoxelMap::NewBlock() {
  uint32_t block;
  if (free_blocks_.empty()) {
    block = static_cast<uint32_t>(blocks_.size());
    blocks_.emplace_back();
    coordinates_.resize(coordinates_.size() + 3 * block_capacity_);
    labels_.resize(labels_.size() + block_capacity_);
    certainties_.resize(certainties_.size() + block_capacity_);
  } else {
    block = free_blocks_.back();
    free_blocks_.pop_back();
    blocks_[block] = Block();
  }
  std::fill_n(Coordinates(block), 3 * block_capacity_, kNowhere);
  return block;
}

void LabeledVoxelMap::FreeBlocks(uint32_t first_block) {
  for (uint32_t block = first_block; block != VoxelIndex::kNone; block = blocks_[block].next) {
    num_points_ -= blocks_[block].size;
    free_blocks_.push_back(block);
  }
}

void LabeledVoxelMap::RemoveFarFrom(const Eigen::Vector3d& center, double distance_m) {
  for (uint32_t i = 0; i < voxels_.size();) {
    const Voxel& voxel = voxels_[i];
    const float* const first = Coordinates(voxel.first_block);
    const Eigen::Vector3d point =
        Corner(voxel.coordinates) +
        Eigen::Vector3d(first[0], first[block_capacity_], first[2 * block_capacity_]);
    if ((point - center).squaredNorm() < distance_m * distance_m) {
      ++i;
      continue;
    }
    FreeBlocks(voxel.first_block);
    index_.Erase(KeyOf(voxel.coordinates));
    if (i + 1 < voxels_.size()) {
      voxels_[i] = voxels_.back();
      index_.Assign(KeyOf(voxels_[i].coordinates), i);
    }
    voxels_.pop_back();
  }
}

void LabeledVoxelMap::Clear() {
  index_.Clear();
  voxels_.clear();
  blocks_.clear();
  coordinates_.clear();
  labels_.clear();
  certainties_.clear();
  free_blocks_.clear();
  num_points_ = 0;
}

void LabeledVoxelMap::SearchVoxel(const VoxelCoordinates& coordinates,
                                  const Eigen::Vector3f& query_offset, Candidate* best) const {
  const uint32_t found = index_.Find(KeyOf(coordinates));
  if (found == VoxelIndex::kNone) return;
  const Floats zero = {};
  const Floats query_x = query_offset.x() + zero;
  const Floats query_y = query_offset.y() + zero;
  const Floats query_z = query_offset.z() + zero;
  for (uint32_t block = voxels_[found].first_block; block != VoxelIndex::kNone;
       block = blocks_[block].next) {
    const float* const x = Coordinates(block);
    const float* const y = x + block_capacity_;
    const float* const z = y + block_capacity_;
    Floats nearest = best->squared_distance + zero;
    Ints where = Ints{} - 1;
    // Slots beyond the size hold kNowhere, so whole groups of lanes can be read.
    for (uint32_t i = 0; i < blocks_[block].size; i += kLanes) {
      const Floats dx = Load(x + i) - query_x;
      const Floats dy = Load(y + i) - query_y;
      const Floats dz = Load(z + i) - query_z;
      const Floats squared_distance = dx * dx + dy * dy + dz * dz;
      const Ints nearer = squared_distance < nearest;
      nearest = nearer ? squared_distance : nearest;
      where = nearer ? Ints{} + static_cast<int32_t>(i) : where;
    }
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
      if (where[lane] >= 0 && nearest[lane] < best->squared_distance) {
        *best = {nearest[lane], coordinates, block, static_cast<uint32_t>(where[lane]) + lane};
      }
    }
  }
}

std::optional<LabeledVoxelMap::Neighbor> LabeledVoxelMap::FindNearest(const Eigen::Vector3d& query,
                                                                      double max_distance_m) const {
  const VoxelCoordinates voxel = VoxelOf(query, inverse_voxel_size_);
  const Eigen::Vector3f offset = (query - Corner(voxel)).cast<float>();
  const float size = static_cast<float>(voxel_size_);
  // Squared distances to the near sides of the neighbours below and above, by axis.
  const Eigen::Array3f below = offset.array().square();
  const Eigen::Array3f above = (size - offset.array()).square();

  Candidate best;
  best.squared_distance = static_cast<float>(max_distance_m * max_distance_m);
  SearchVoxel(voxel, offset, &best);
  // Most neighbours lie farther away than the best point so far; whole rows and layers of them are
  // skipped at once.
  const auto gap = [&](int axis, int shift) {
    return shift == 0 ? 0.f : shift < 0 ? below[axis] : above[axis];
  };
  for (const int z : kNearShiftsFirst) {
    if (gap(2, z) >= best.squared_distance) continue;
    for (const int y : kNearShiftsFirst) {
      if (gap(2, z) + gap(1, y) >= best.squared_distance) continue;
      for (const int x : kNearShiftsFirst) {
        if ((x == 0 && y == 0 && z == 0) ||
            gap(2, z) + gap(1, y) + gap(0, x) >= best.squared_distance) {
          continue;
        }
        const Eigen::Array3i shift(x, y, z);
        SearchVoxel(voxel + shift, offset - shift.cast<float>().matrix() * size, &best);
      }
    }
  }
  if (best.block == VoxelIndex::kNone) return std::nullopt;

  const float* const coordinates = Coordinates(best.block);
  const Eigen::Vector3d position =
      Corner(best.voxel) + Eigen::Vector3d(coordinates[best.slot],
                                           coordinates[block_capacity_ + best.slot],
                                           coordinates[2 * block_capacity_ + best.slot]);
  return Neighbor{position, labels_[size_t{best.block} * block_capacity_ + best.slot],
                  (position - query).squaredNorm()};
}

sensor::LabeledPointCloud LabeledVoxelMap::ToPointCloud() const {
  sensor::LabeledPointCloud cloud;
  cloud.Reserve(num_points_);
  for (const Voxel& voxel : voxels_) {
    const Eigen::Vector3d corner = Corner(voxel.coordinates);
    for (uint32_t block = voxel.first_block; block != VoxelIndex::kNone;
         block = blocks_[block].next) {
      const float* const x = Coordinates(block);
      for (uint32_t i = 0; i < blocks_[block].size; ++i) {
        const Eigen::Vector3d offset(x[i], x[block_capacity_ + i], x[2 * block_capacity_ + i]);
        cloud.positions.push_back((corner + offset).cast<float>());
        cloud.labels.push_back(labels_[size_t{block} * block_capacity_ + i]);
        cloud.certainties.push_back(certainties_[size_t{block} * block_capacity_ + i]);
      }
    }
  }
  return cloud;
}

}  // namespace cartographer::registration
