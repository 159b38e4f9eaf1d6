// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_MATCHING_SCAN_H_
#define CARTOGRAPHER_SCAN_MATCHING_MATCHING_SCAN_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::scan_matching {

// Points of a scan that fall into one cell and are of one layer.
struct ScanCell {
  int x, y;
  int weight;  // sum over the points, <= kMaxCellWeight
};
inline constexpr int kMaxCellWeight = 32767;

// Cells in which the points of a scan are. A cell may be listed more than once.
struct ScanCells {
  struct Layer {
    int layer;
    size_t begin, end;  // in `cells`
  };
  std::vector<ScanCell> cells;
  std::vector<Layer> layers;  // none of them empty, ascending
};

// A node's cloud made ready to be matched with any number of submaps: the points that count, in the
// plane, ordered by layer and within a layer along a space-filling curve. Points that are
// neighbours in space are then neighbours in memory, at every heading: their look-ups hit the same
// cache lines, and those that share a cell follow each other.
class MatchingScan {
 public:
  // `cloud` is in the node's frame, which must be level (z up along gravity). Points without a
  // layer, beyond the model's max_range_m or with a coordinate that is not finite are left out.
  // Of more than `max_points` (> 0) points, or a total weight above 131 000 (sums are 32 bits
  // wide), only every second (third, ...) point along the curve is kept.
  MatchingScan(const sensor::LabeledPointCloud& cloud, const ScoreModel& model,
               size_t max_points = std::numeric_limits<size_t>::max());

  bool empty() const { return weights_.empty(); }
  size_t size() const { return weights_.size(); }
  // The denominator of the score, in steps of 1/64; > 0 unless empty.
  int64_t total_weight() const { return total_weight_; }
  // Distance of the farthest point [m]; 0 if empty.
  double radius_m() const { return radius_m_; }

  // The cells of the points in a grid whose cells are `resolution_m` wide; their weights add up to
  // total_weight().
  ScanCells CellsAt(const PlanarPose& grid_from_node, double resolution_m) const;

  // Calls visitor(layer, position in the node's frame [m], weight in steps of 1/64) for every
  // point, always in the same order.
  template <typename Visitor>
  void ForEachPoint(const Visitor& visitor) const {
    for (const Layer& layer : layers_) {
      for (size_t i = layer.begin; i < layer.end; ++i) {
        visitor(layer.layer, Eigen::Vector2d(x_[i], y_[i]), weights_[i]);
      }
    }
  }

 private:
  struct Layer {
    int layer;
    size_t begin, end;  // in the columns below
  };

  std::vector<float> x_, y_;  // [m], node's frame
  std::vector<int> weights_;
  std::vector<Layer> layers_;
  int64_t total_weight_ = 0;
  double radius_m_ = 0.;
};

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_MATCHING_SCAN_H_
