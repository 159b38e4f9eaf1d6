// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_PLACE_DESCRIPTOR_H_
#define CARTOGRAPHER_POSE_GRAPH_PLACE_DESCRIPTOR_H_

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/pose_graph/proto/place_recognition_options.pb.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// What stands around a point, by channel of labels: a plain value that is compared with others of
// the same PlaceDescriber.
//
// The surroundings are cut into rings, and the amount of a channel on a ring, a function of the
// bearing, is kept as its first Fourier coefficients: turning the place by an angle multiplies
// coefficient k by exp(-i k angle), so that all headings are compared at once.
struct PlaceDescriptor {
  // The point, in the frame that was described.
  Eigen::Vector2d center{0., 0.};
  // Real and imaginary parts of coefficient 1, ..., num_harmonics of every row (a row: a ring of a
  // channel), row by row; scaled so that two places that agree in all compare as 1. Empty: there is
  // nothing around the point.
  std::vector<float> coefficients;

  bool empty() const { return coefficients.empty(); }
};

// Describes places. An immutable value.
class PlaceDescriber {
 public:
  // A cloud and where it stands in the frame that is described.
  struct Part {
    const sensor::LabeledPointCloud& cloud;
    transform::Rigid3d frame_from_cloud;
  };

  // Errors name the group, as those of scan_matching::ScoreModel.
  static absl::StatusOr<PlaceDescriber> Create(const proto::PlaceRecognitionOptions& options,
                                               const sensor::LabelSet& labels);

  // What the clouds show around `center`, a point of their common frame, which must be level. A
  // finished submap's cloud is one part; a short drive's clouds are several. `center` should be
  // where they were taken from, the middle of the way. Points that are not finite are left out.
  PlaceDescriptor Describe(const std::vector<Part>& parts, const Eigen::Vector2d& center) const;

  int num_rows() const { return num_channels_ * num_rings_; }
  int num_harmonics() const { return num_harmonics_; }

 private:
  PlaceDescriber(const proto::PlaceRecognitionOptions& options, scan_matching::ScoreModel model);

  // Adds the points of a part to the polar cells, row by row.
  void AddPoints(const Part& part, const Eigen::Vector2d& center,
                 std::vector<float>* amounts) const;

  scan_matching::ScoreModel model_;
  int num_channels_;
  int num_rings_;
  int num_harmonics_;
  double radius_m_;
  // By channel: weight, and points per m^2 from which on a cell is full.
  std::vector<float> weights_, saturations_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_PLACE_DESCRIPTOR_H_
