// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/labeled_voxel_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "glog/logging.h"

namespace cartographer::registration {
namespace {

// Distances to four points at a time. Compilers vectorize sums but not "smallest and where", hence
// the explicit lanes (a GCC and Clang extension that falls back to scalars elsewhere).
constexpr uint32_t kLanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Ints = int32_t __attribute__((vector_size(16)));
using Bytes = uint8_t __attribute__((vector_size(4)));

// How much farther [voxels] than the best point so far the search looks, only to tell how much
// farther the second best is. Larger values make a search slower and its answer valid for longer.
constexpr float kLookBeyond = 0.05f;

// Where no point is; far enough that it never is the nearest.
constexpr float kNowhere = 1e15f;

Floats Load(const float* values) {
  Floats lanes;
  __builtin_memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

constexpr std::array<int, 3> kNearShiftsFirst = {0, -1, 1};

// From `offset` to the points at `x`, `x + stride`, `x + 2 * stride` and the three after them.
// Slots beyond a block's size hold kNowhere, so whole groups of lanes can be read.
Floats SquaredDistances(const float* x, uint32_t stride, const Eigen::Vector3f& offset) {
  const Floats dx = Load(x) - offset.x();
  const Floats dy = Load(x + stride) - offset.y();
  const Floats dz = Load(x + 2 * stride) - offset.z();
  return dx * dx + dy * dy + dz * dz;
}

bool AnyLane(const Ints& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

// Measures of points: distance alone.
struct ByDistance {
  Floats Weigh(const Floats& squared_distances, const sensor::Label*) const {
    return squared_distances;
  }
  // What squared distances are multiplied by at least.
  float smallest_factor() const { return 1.f; }
};

// The same, but points whose label agrees with `label`, or has nothing to disagree with, count as
// nearer.
struct ByDistanceAndLabel {
  Floats Weigh(const Floats& squared_distances, const sensor::Label* labels) const {
    Bytes bytes;
    __builtin_memcpy(&bytes, labels, sizeof(bytes));
    const Ints theirs = __builtin_convertvector(bytes, Ints);
    const Ints agrees = (theirs == label) | (theirs == static_cast<int32_t>(sensor::kUnlabeled));
    return agrees ? squared_distances * agreeing_factor : squared_distances;
  }
  float smallest_factor() const { return agreeing_factor; }

  int32_t label;
  float agreeing_factor;
};

uint32_t RoundUpToLanes(uint32_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

}  // namespace

// The state of one search: the nearest point so far, by where it is stored, and what is known of
// all others.
struct LabeledVoxelMap::Search {
  // Whether a voxel whose nearest side is that far away may hold something of interest; if not, its
  // distance bounds that of the points in it.
  bool MayHelp(float squared_gap) {
    if (squared_gap < squared_horizon) return true;
    squared_others = std::min(squared_others, squared_gap);
    return false;
  }

  void Improve(float squared_distance, const VoxelCoordinates& in_voxel, uint32_t in_block,
               uint32_t in_slot) {
    if (squared_distance >= squared_nearest) {
      squared_others = std::min(squared_others, squared_distance);
      return;
    }
    if (block != VoxelIndex::kNone) squared_others = std::min(squared_others, squared_nearest);
    squared_nearest = squared_distance;
    voxel = in_voxel;
    block = in_block;
    slot = in_slot;
    SetHorizon();
  }

  void SetHorizon() {
    const float horizon = std::sqrt(squared_nearest) + look_beyond;
    squared_horizon = horizon * horizon;
  }

  float look_beyond;
  float squared_nearest;
  float squared_horizon;
  float squared_others = std::numeric_limits<float>::max();
  VoxelCoordinates voxel{0, 0, 0};
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
          options.allow_crowding()
              ? 0.f
              : static_cast<float>(voxel_size_ * voxel_size_ / options.max_points_per_voxel())),
      displace_unlabeled_(options.displace_unlabeled()),
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
  if (HasRoom(voxel, offset, critical)) {
    Append(&voxel, offset, label, certainty);
  } else if (displace_unlabeled_ && label != sensor::kUnlabeled) {
    Displace(voxel, offset, label, certainty);
  }
}

void LabeledVoxelMap::Displace(const Voxel& voxel, const Eigen::Vector3f& offset,
                               sensor::Label label, float certainty) {
  for (uint32_t block = voxel.first_block; block != VoxelIndex::kNone;
       block = blocks_[block].next) {
    for (uint32_t slot = 0; slot < blocks_[block].size; ++slot) {
      if (labels_[size_t{block} * block_capacity_ + slot] != sensor::kUnlabeled) continue;
      Store(block, slot, offset, label, certainty);
      return;
    }
  }
}

bool LabeledVoxelMap::HasRoom(const Voxel& voxel, const Eigen::Vector3f& offset,
                              bool critical) const {
  if (critical && voxel.num_critical < max_critical_) return true;
  if (voxel.num_ordinary >= max_ordinary_) return false;
  if (min_squared_distance_ == 0.f) return true;
  for (uint32_t block = voxel.first_block; block != VoxelIndex::kNone;
       block = blocks_[block].next) {
    Ints too_close = {};
    for (uint32_t i = 0; i < blocks_[block].size; i += kLanes) {
      too_close |= SquaredDistances(Coordinates(block) + i, block_capacity_, offset) <
                   min_squared_distance_ + Floats{};
    }
    if (AnyLane(too_close)) return false;
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
  Store(block, blocks_[block].size++, offset, label, certainty);
  const bool counts_as_critical = critical_.Contains(label) && voxel->num_critical < max_critical_;
  ++(counts_as_critical ? voxel->num_critical : voxel->num_ordinary);
  ++num_points_;
}

void LabeledVoxelMap::Store(uint32_t block, uint32_t slot, const Eigen::Vector3f& offset,
                            sensor::Label label, float certainty) {
  float* const coordinates = Coordinates(block);
  for (int axis = 0; axis < 3; ++axis) coordinates[axis * block_capacity_ + slot] = offset[axis];
  labels_[size_t{block} * block_capacity_ + slot] = label;
  certainties_[size_t{block} * block_capacity_ + slot] = certainty;
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

template <typename Measure>
void LabeledVoxelMap::SearchVoxel(const Measure& measure, const VoxelCoordinates& coordinates,
                                  const Eigen::Vector3f& query_offset, Search* search) const {
  const uint32_t found = index_.Find(KeyOf(coordinates));
  if (found == VoxelIndex::kNone) return;
  for (uint32_t block = voxels_[found].first_block; block != VoxelIndex::kNone;
       block = blocks_[block].next) {
    const float squared_horizon = search->squared_horizon;
    Floats nearest = squared_horizon + Floats{};
    Floats second = nearest;
    Ints where = Ints{} - 1;
    for (uint32_t i = 0; i < blocks_[block].size; i += kLanes) {
      const Floats distance =
          measure.Weigh(SquaredDistances(Coordinates(block) + i, block_capacity_, query_offset),
                        &labels_[size_t{block} * block_capacity_ + i]);
      const Ints nearer = distance < nearest;
      const Floats loser = nearer ? nearest : distance;
      second = loser < second ? loser : second;
      nearest = nearer ? distance : nearest;
      where = nearer ? Ints{} + static_cast<int32_t>(i) : where;
    }
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
      if (where[lane] < 0) continue;
      search->Improve(nearest[lane], coordinates, block, static_cast<uint32_t>(where[lane]) + lane);
      search->squared_others = std::min(search->squared_others, second[lane]);
    }
    // Points beyond the horizon were not told apart.
    search->squared_others = std::min(search->squared_others, squared_horizon);
  }
}

LabeledVoxelMap::Nearest LabeledVoxelMap::FindNearest(const Eigen::Vector3d& query,
                                                      double max_distance_m) const {
  return FindBy(ByDistance(), query, max_distance_m);
}

LabeledVoxelMap::Nearest LabeledVoxelMap::FindPreferred(const Eigen::Vector3d& query,
                                                        sensor::Label label,
                                                        double agreeing_factor) const {
  // Farther than the 27 voxels reach, nearer than empty slots are.
  const double everywhere_m = 4. * voxel_size_;
  if (label == sensor::kUnlabeled) {
    Nearest nearest = FindBy(ByDistance(), query, everywhere_m);
    nearest.others_beyond_m *= static_cast<float>(std::sqrt(agreeing_factor));
    return nearest;
  }
  return FindBy(
      ByDistanceAndLabel{static_cast<int32_t>(label), static_cast<float>(agreeing_factor)}, query,
      everywhere_m);
}

template <typename Measure>
LabeledVoxelMap::Nearest LabeledVoxelMap::FindBy(const Measure& measure,
                                                 const Eigen::Vector3d& query,
                                                 double max_distance_m) const {
  const VoxelCoordinates voxel = VoxelAt(query);
  const Eigen::Vector3f offset = (query - Corner(voxel)).cast<float>();
  const float size = static_cast<float>(voxel_size_);
  // The least measure of points in the neighbours below and above, by axis.
  const Eigen::Array3f below = measure.smallest_factor() * offset.array().square();
  const Eigen::Array3f above = measure.smallest_factor() * (size - offset.array()).square();
  const auto gap = [&](int axis, int shift) {
    return shift == 0 ? 0.f : shift < 0 ? below[axis] : above[axis];
  };

  Search search;
  search.look_beyond = kLookBeyond * size;
  search.squared_nearest = static_cast<float>(max_distance_m * max_distance_m);
  search.SetHorizon();
  // Most neighbours lie farther away than the best point so far; whole rows and layers of them are
  // skipped at once.
  for (const int z : kNearShiftsFirst) {
    if (!search.MayHelp(gap(2, z))) continue;
    for (const int y : kNearShiftsFirst) {
      if (!search.MayHelp(gap(2, z) + gap(1, y))) continue;
      for (const int x : kNearShiftsFirst) {
        if (!search.MayHelp(gap(2, z) + gap(1, y) + gap(0, x))) continue;
        const Eigen::Array3i shift(x, y, z);
        SearchVoxel(measure, voxel + shift, offset - shift.cast<float>().matrix() * size, &search);
      }
    }
  }

  Nearest result;
  result.others_beyond_m = std::sqrt(search.squared_others);
  if (search.block == VoxelIndex::kNone) return result;
  const float* const x = Coordinates(search.block) + search.slot;
  const Eigen::Vector3d found(x[0], x[block_capacity_], x[2 * block_capacity_]);
  result.neighbor = {Corner(search.voxel) + found,
                     labels_[size_t{search.block} * block_capacity_ + search.slot]};
  return result;
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
