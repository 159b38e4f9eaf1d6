// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SENSOR_LABEL_H_
#define CARTOGRAPHER_SENSOR_LABEL_H_

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace cartographer::sensor {

// A class of a label set (label_set.h): its dense index there, not the id that files use.
// 0 means unlabeled in every set.
enum class Label : uint8_t {};
inline constexpr Label kUnlabeled{0};

// Whether there is nothing in which two labels differ: they are the same, or one says nothing.
constexpr bool LabelsAgree(Label a, Label b) {
  return a == b || a == kUnlabeled || b == kUnlabeled;
}

inline constexpr size_t kMaxLabels = 256;

constexpr size_t Index(Label label) { return static_cast<size_t>(label); }

// What a class is for; code asks for roles, never for ids or names. A class may have several.
enum class LabelRole : uint8_t {
  kMoving,    // in motion while scanned: dropped by the odometry
  kMovable,   // may be gone tomorrow (parked cars): kept for odometry, removable from maps
  kCritical,  // small, rigid, rare (poles, signs): spared by sub-sampling
  kGround,    // gives the height
  kUnlabeled  // says nothing: annotators' "unlabeled", outliers
};
inline constexpr size_t kNumLabelRoles = 5;

// A set of labels with constant-time look-up.
class LabelMask {
 public:
  bool Contains(Label label) const { return bits_[Index(label)]; }
  void Insert(Label label) { bits_.set(Index(label)); }
  void Insert(const LabelMask& labels) { bits_ |= labels.bits_; }
  bool Empty() const { return bits_.none(); }

  friend bool operator==(const LabelMask& a, const LabelMask& b) { return a.bits_ == b.bits_; }

 private:
  std::bitset<kMaxLabels> bits_;
};

}  // namespace cartographer::sensor

#endif  // CARTOGRAPHER_SENSOR_LABEL_H_
