// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_REGISTRATION_VOXEL_INDEX_H_
#define CARTOGRAPHER_REGISTRATION_VOXEL_INDEX_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cartographer/registration/voxel.h"

namespace cartographer::registration {

// A hash table from voxel keys to 32-bit numbers: open addressing with linear probing in one flat
// array, at most a third full, so that most look-ups touch one cache line. It is the innermost
// structure of the odometry, which is why it is not a general container.
class VoxelIndex {
 public:
  static constexpr uint32_t kNone = 0xffffffff;

  // Room for `expected_size` voxels without rehashing.
  explicit VoxelIndex(size_t expected_size = 0);

  // The number stored under the key, or kNone.
  uint32_t Find(VoxelKey key) const {
    for (size_t slot = SlotOf(key);; slot = (slot + 1) & mask_) {
      if (slots_[slot].value == kNone || slots_[slot].key == key) return slots_[slot].value;
    }
  }

  // The number stored under the key; if there is none, stores `value` (not kNone) and returns
  // kNone.
  uint32_t FindOrInsert(VoxelKey key, uint32_t value);

  // Overwrites the number of a key that is there (CHECKed in debug builds).
  void Assign(VoxelKey key, uint32_t value);

  // Removes a key that is there.
  void Erase(VoxelKey key);

  void Clear();
  size_t size() const { return size_; }

 private:
  struct Slot {
    VoxelKey key = 0;
    uint32_t value = kNone;
  };

  size_t SlotOf(VoxelKey key) const {
    return static_cast<size_t>((key * 0x9e3779b97f4a7c15u) >> shift_);
  }
  size_t FindSlot(VoxelKey key) const;
  void Grow();

  std::vector<Slot> slots_;
  size_t mask_;
  int shift_;
  size_t size_ = 0;
};

}  // namespace cartographer::registration

#endif  // CARTOGRAPHER_REGISTRATION_VOXEL_INDEX_H_
