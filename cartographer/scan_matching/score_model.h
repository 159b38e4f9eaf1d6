// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_SCORE_MODEL_H_
#define CARTOGRAPHER_SCAN_MATCHING_SCORE_MODEL_H_

#include <array>
#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/scan_matching/proto/scan_matching_options.pb.h"
#include "cartographer/sensor/label.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::scan_matching {

// The score of a scan at a pose in a submap's grid, compiled from its options for a label set. An
// immutable value.
//
// Point i with label y_i falls into cell c_i. The score is the weighted mean, in [0, 1],
//
//   score = sum_i w(y_i) v(y_i, c_i) / sum_i w(y_i),
//
// so that 1 means that every point that counts agrees fully, whatever share of them is ground. With
// h(y, c) the hits of label y in cell c, f_y(h) = min(1, h / saturation_hits of y's group), and the
// dominant label of a cell as in submap/semantic_grid.h, agreement v is
//
//   dominant_label   f_y(h(y, c)) if y dominates c, else partial_agreement * f_y(h(y, c))
//   max_layer        f_y(h(y, c))
//   occupancy        1 if any label but those of the ground was hit in c, else 0
//
// Weights w are those of the groups; with occupancy they are 1, and 0 for ground and moving labels.
// All of it is done in integers, so that sums do not depend on their order: v in steps of 1/255, w
// in steps of 1/64.
//
// Labels that share their agreement with cells share a `layer`: with occupancy there is one layer,
// otherwise each label of weight > 0 is one. Layers that share bounds in the search share a
// `group`.
class ScoreModel {
 public:
  static constexpr int kNotMatched = -1;
  static constexpr int kFullAgreement = 255;
  static constexpr int kWeightSteps = 64;

  // Errors name the group: an unknown label or role, a label that several groups name.
  static absl::StatusOr<ScoreModel> Create(const proto::ScoreOptions& options,
                                           const sensor::LabelSet& labels);

  // Layers count from 0 in the order of their groups; kNotMatched: the label does not count.
  int LayerOf(sensor::Label label) const { return layer_of_label_[sensor::Index(label)]; }
  int num_layers() const { return static_cast<int>(group_of_layer_.size()); }
  int GroupOf(int layer) const { return group_of_layer_[layer]; }
  int num_groups() const { return group_of_layer_.empty() ? 0 : group_of_layer_.back() + 1; }

  // Weight of a point, in steps of 1/64.
  int WeightOf(sensor::Label label) const { return weight_of_label_[sensor::Index(label)]; }

  // Hits from which on a cell agrees as much as it can, >= 1.
  int SaturationOf(int layer) const { return saturation_of_layer_[layer]; }
  // Agreement of a point with a cell that has `hits` of its layer, in steps of 1/255.
  int Agreement(int layer, int hits, bool dominant) const;

  // Whether cells agree by what was hit at all, so that `hits` are those of any label of the layer.
  bool occupancy() const { return occupancy_; }
  double max_range_m() const { return max_range_m_; }

 private:
  ScoreModel() = default;

  void AddLayers(const std::vector<sensor::Label>& labels, const proto::LabelGroup& options);
  void UseOccupancy(const sensor::LabelSet& labels);

  bool occupancy_ = false;
  double partial_agreement_ = 0.;
  double max_range_m_ = 0.;
  std::array<int, sensor::kMaxLabels> layer_of_label_{};
  std::array<int, sensor::kMaxLabels> weight_of_label_{};
  std::vector<int> group_of_layer_;
  std::vector<int> saturation_of_layer_;
};

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_SCORE_MODEL_H_
