// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/voxel_index.h"

#include "glog/logging.h"

namespace cartographer::registration {
namespace {

constexpr int kMinBits = 8;
constexpr size_t kSlotsPerEntry = 3;

int BitsFor(size_t expected_size) {
  int bits = kMinBits;
  while ((size_t{1} << bits) < expected_size * kSlotsPerEntry) ++bits;
  return bits;
}

}  // namespace

VoxelIndex::VoxelIndex(size_t expected_size) {
  const int bits = BitsFor(expected_size);
  slots_.resize(size_t{1} << bits);
  mask_ = slots_.size() - 1;
  shift_ = 64 - bits;
}

uint32_t VoxelIndex::FindOrInsert(VoxelKey key, uint32_t value) {
  DCHECK_NE(value, kNone);
  const size_t slot = FindSlot(key);
  if (slots_[slot].value != kNone) return slots_[slot].value;
  slots_[slot] = {key, value};
  if (++size_ * kSlotsPerEntry > slots_.size()) Grow();
  return kNone;
}

void VoxelIndex::Assign(VoxelKey key, uint32_t value) {
  Slot& slot = slots_[FindSlot(key)];
  DCHECK_NE(slot.value, kNone);
  slot.value = value;
}

void VoxelIndex::Erase(VoxelKey key) {
  size_t hole = FindSlot(key);
  DCHECK_NE(slots_[hole].value, kNone);
  // Later entries of the probe run move up into the hole, so that no tombstones pile up.
  for (size_t next = (hole + 1) & mask_; slots_[next].value != kNone; next = (next + 1) & mask_) {
    const size_t home = SlotOf(slots_[next].key);
    if (((next - home) & mask_) >= ((next - hole) & mask_)) {
      slots_[hole] = slots_[next];
      hole = next;
    }
  }
  slots_[hole].value = kNone;
  --size_;
}

void VoxelIndex::Clear() {
  slots_.assign(slots_.size(), Slot());
  size_ = 0;
}

size_t VoxelIndex::FindSlot(VoxelKey key) const {
  size_t slot = SlotOf(key);
  while (slots_[slot].value != kNone && slots_[slot].key != key) slot = (slot + 1) & mask_;
  return slot;
}

void VoxelIndex::Grow() {
  std::vector<Slot> old_slots(2 * slots_.size());
  old_slots.swap(slots_);
  mask_ = slots_.size() - 1;
  --shift_;
  for (const Slot& slot : old_slots) {
    if (slot.value != kNone) slots_[FindSlot(slot.key)] = slot;
  }
}

}  // namespace cartographer::registration
