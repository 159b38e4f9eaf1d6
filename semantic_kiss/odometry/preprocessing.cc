// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/preprocessing.h"

#include <optional>
#include <utility>
#include <vector>

#include "cartographer/common/parallel.h"
#include "semantic_kiss/odometry/deskew.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabelMask;

constexpr size_t kPointsPerChunk = 16384;

// Sorts points into those that stay and the reasons why others don't.
class PointFilter {
 public:
  PointFilter(const LabelMask& dropped_labels, const proto::PreprocessingOptions& options)
      : dropped_labels_(dropped_labels),
        min_squared_(Square(options.min_range_m())),
        max_squared_(Square(options.max_range_m())),
        label_max_squared_(Square(options.label_max_range_m())) {}

  bool Keep(const Eigen::Vector3f& position, cartographer::sensor::Label label,
            PreprocessingCounts* counts) const {
    if (!position.allFinite()) {
      ++counts->not_finite;
      return false;
    }
    const float squared_range = position.squaredNorm();
    if (!(squared_range > min_squared_ && squared_range < max_squared_)) {
      ++counts->out_of_range;
      return false;
    }
    if (dropped_labels_.Contains(label)) {
      ++counts->moving;
      return false;
    }
    ++counts->kept;
    return true;
  }

  bool TrustsLabel(const Eigen::Vector3f& position) const {
    return position.squaredNorm() < label_max_squared_;
  }

 private:
  static float Square(double value) { return static_cast<float>(value * value); }

  const LabelMask& dropped_labels_;
  const float min_squared_, max_squared_, label_max_squared_;
};

PreprocessedScan PreprocessChunk(const LabeledPointCloud& scan, size_t begin, size_t end,
                                 const std::optional<SweepMotion>& sweep,
                                 const PointFilter& filter) {
  PreprocessedScan chunk;
  chunk.points.Reserve(end - begin);
  for (size_t i = begin; i < end; ++i) {
    const Eigen::Vector3f position =
        sweep.has_value() ? sweep->ToSweepEnd(scan.positions[i], scan.times[i]) : scan.positions[i];
    if (!filter.Keep(position, scan.labels[i], &chunk.counts)) continue;
    chunk.points.positions.push_back(position);
    chunk.points.labels.push_back(filter.TrustsLabel(position) ? scan.labels[i]
                                                               : cartographer::sensor::kUnlabeled);
    chunk.points.certainties.push_back(scan.certainties[i]);
  }
  return chunk;
}

template <typename T>
void AppendAll(const std::vector<T>& from, std::vector<T>* to) {
  to->insert(to->end(), from.begin(), from.end());
}

}  // namespace

PreprocessedScan Preprocess(const LabeledPointCloud& scan,
                            const cartographer::transform::Twist& motion,
                            const LabelMask& dropped_labels,
                            const proto::PreprocessingOptions& options) {
  std::optional<SweepMotion> sweep;
  if (options.deskew()) sweep = SweepMotion::Create(scan.times, motion);
  const PointFilter filter(dropped_labels, options);

  PreprocessedScan result;
  result.deskewed = sweep.has_value();
  result.points.Reserve(scan.size());
  for (const PreprocessedScan& chunk : cartographer::common::ParallelMapChunks<PreprocessedScan>(
           scan.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
             return PreprocessChunk(scan, begin, end, sweep, filter);
           })) {
    AppendAll(chunk.points.positions, &result.points.positions);
    AppendAll(chunk.points.labels, &result.points.labels);
    AppendAll(chunk.points.certainties, &result.points.certainties);
    result.counts.kept += chunk.counts.kept;
    result.counts.not_finite += chunk.counts.not_finite;
    result.counts.out_of_range += chunk.counts.out_of_range;
    result.counts.moving += chunk.counts.moving;
  }
  return result;
}

}  // namespace semantic_kiss::odometry
