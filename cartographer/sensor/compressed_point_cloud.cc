// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/sensor/compressed_point_cloud.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/status.h"

namespace cartographer::sensor {
namespace {

constexpr double kStep_m = 1e-3;
constexpr double kStepsPerMeter = 1e3;
constexpr int kBits = 10;  // of a coordinate within its block
constexpr int kStepMask = (1 << kBits) - 1;
// Cartographer refuses points with larger coordinates.
constexpr int kMaxSteps = (1 << 23) - 1;
constexpr int kMaxBlock = kMaxSteps >> kBits;
constexpr int kMinBlock = -kMaxBlock - 1;

using Steps = Eigen::Array3i;

struct SortedPoint {
  uint64_t block;  // sorts by z, y, x
  uint32_t index;
  int steps;  // within the block, packed

  friend bool operator<(const SortedPoint& a, const SortedPoint& b) {
    return a.block != b.block ? a.block < b.block : a.index < b.index;
  }
};

constexpr int kBlockKeyBits = 20;

uint64_t BlockKey(const Eigen::Array3i& block) {
  const auto part = [](int index) { return static_cast<uint64_t>(index - kMinBlock); };
  return (part(block.z()) << kBlockKeyBits | part(block.y())) << kBlockKeyBits | part(block.x());
}

Eigen::Array3i BlockOfKey(uint64_t key) {
  const auto part = [key](int shift) {
    return static_cast<int>(key >> shift & ((1 << kBlockKeyBits) - 1)) + kMinBlock;
  };
  return {part(0), part(kBlockKeyBits), part(2 * kBlockKeyBits)};
}

SortedPoint Sortable(const Steps& steps, uint32_t index) {
  const Eigen::Array3i block(steps.x() >> kBits, steps.y() >> kBits, steps.z() >> kBits);
  const int packed = ((steps.z() & kStepMask) << kBits | (steps.y() & kStepMask)) << kBits |
                     (steps.x() & kStepMask);
  return {BlockKey(block), index, packed};
}

absl::StatusOr<std::vector<SortedPoint>> SortIntoBlocks(
    const std::vector<Eigen::Vector3d>& positions) {
  std::vector<SortedPoint> points;
  points.reserve(positions.size());
  for (const Eigen::Vector3d& position : positions) {
    const Eigen::Array3d steps = (position.array() * kStepsPerMeter).round();
    // Written so that NaN fails, too.
    if (!(steps.abs() <= kMaxSteps).all()) {
      return absl::InvalidArgumentError(absl::StrFormat(
          "point %d at (%g, %g, %g) m cannot be stored: coordinates must be finite and within "
          "+-8388.607 m",
          points.size(), position.x(), position.y(), position.z()));
    }
    points.push_back(Sortable(steps.cast<int>(), static_cast<uint32_t>(points.size())));
  }
  std::sort(points.begin(), points.end());
  return points;
}

// Reads one block of `data` from `*next` on.
absl::Status DecompressBlock(const google::protobuf::RepeatedField<int32_t>& data, int* next,
                             std::vector<Eigen::Vector3d>* positions) {
  constexpr int kHeaderSize = 4;
  const int remaining = data.size() - *next;
  const int num_points = data[*next];
  if (remaining < kHeaderSize || num_points < 0 || num_points > remaining - kHeaderSize) {
    return absl::DataLossError(absl::StrCat("point ", positions->size(), ": a block of ",
                                            num_points, " points does not fit the remaining ",
                                            remaining, " numbers"));
  }
  const Eigen::Array3i block(data[*next + 1], data[*next + 2], data[*next + 3]);
  if ((block < kMinBlock).any() || (block > kMaxBlock).any()) {
    return absl::DataLossError(
        absl::StrCat("point ", positions->size(), ": its block lies beyond 8388 m"));
  }
  *next += kHeaderSize;
  for (const int end = *next + num_points; *next < end; ++*next) {
    const int packed = data[*next];
    if (packed < 0 || packed >> (3 * kBits) != 0) {
      return absl::DataLossError(
          absl::StrCat("point ", positions->size(), ": ", packed, " is no position in a block"));
    }
    const Steps in_block(packed & kStepMask, packed >> kBits & kStepMask, packed >> (2 * kBits));
    const Steps steps = block * (1 << kBits) + in_block;
    if ((steps < -kMaxSteps).any()) return absl::DataLossError("a point lies beyond 8388 m");
    positions->push_back(steps.cast<double>().matrix() * kStep_m);
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<CompressedPositions> CompressPositions(
    const std::vector<Eigen::Vector3d>& positions) {
  ASSIGN_OR_RETURN(const std::vector<SortedPoint> points, SortIntoBlocks(positions));
  CompressedPositions result;
  result.proto.set_num_points(static_cast<int>(points.size()));
  result.order.reserve(points.size());
  auto& data = *result.proto.mutable_point_data();
  data.Reserve(static_cast<int>(points.size() + points.size() / 2));
  for (size_t begin = 0, end; begin < points.size(); begin = end) {
    end = begin + 1;
    while (end < points.size() && points[end].block == points[begin].block) ++end;
    data.Add(static_cast<int>(end - begin));
    for (const int index : BlockOfKey(points[begin].block)) data.Add(index);
    for (size_t i = begin; i < end; ++i) {
      data.Add(points[i].steps);
      result.order.push_back(points[i].index);
    }
  }
  return result;
}

absl::StatusOr<std::vector<Eigen::Vector3d>> DecompressPositions(
    const proto::CompressedPointCloud& proto) {
  std::vector<Eigen::Vector3d> positions;
  if (proto.num_points() < 0 || proto.num_points() > proto.point_data_size()) {
    return absl::DataLossError(absl::StrCat(proto.num_points(), " points cannot be in ",
                                            proto.point_data_size(), " numbers"));
  }
  positions.reserve(proto.num_points());
  for (int next = 0; next < proto.point_data_size();) {
    RETURN_IF_ERROR(DecompressBlock(proto.point_data(), &next, &positions));
  }
  if (positions.size() != proto.num_points()) {
    return absl::DataLossError(
        absl::StrCat("blocks hold ", positions.size(), " points instead of ", proto.num_points()));
  }
  return positions;
}

}  // namespace cartographer::sensor
