// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_PLACE_DESCRIPTOR_H_
#define CARTOGRAPHER_POSE_GRAPH_PLACE_DESCRIPTOR_H_

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/pose_graph/bearing_transform.h"
#include "cartographer/pose_graph/place_channels.h"
#include "cartographer/pose_graph/place_layers.h"
#include "cartographer/pose_graph/proto/place_recognition_options.pb.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::pose_graph {

// What stands around a point: a plain value that is compared with others of the same
// PlaceDescriber.
struct PlaceDescriptor {
  // The point, in the frame that was described.
  Eigen::Vector2d center{0., 0.};
  // The place as seen from a square grid of points around the centre, row by row (x, then y
  // ascending), by which it is compared with places whose centres are not quite the same. The
  // middle one is the view from the centre. None: nothing stands around the centre.
  std::vector<BearingSpectrum> views;

  bool empty() const { return views.empty(); }
};

// Describes places. An immutable value.
//
// The clouds are drawn from above as one image for each channel of labels, blurred by metres
// (place_layers.h). A view samples the images on rings around its point; the amount on a ring is a
// function of the bearing, of which the first Fourier coefficients are kept (bearing_transform.h),
// so that two views are compared at all headings at once. Every channel is scaled to its weight, so
// that a few poles count as much as many houses, and all together are scaled to 1.
//
// Related: the rings and sectors of Kim and Kim, *Scan Context*, IROS 2018; with labels: Li et al.,
// *SSC: Semantic Scan Context for Large-Scale Place Recognition*, IROS 2021.
class PlaceDescriber {
 public:
  // Errors name the group, as those of scan_matching::ScoreModel.
  static absl::StatusOr<PlaceDescriber> Create(const proto::PlaceRecognitionOptions& options,
                                               const sensor::LabelSet& labels);

  // What the clouds show around `center`, a point of their common frame. A finished submap's cloud
  // is one part; a short drive's clouds are several. `center` should be the middle of the way on
  // which they were taken.
  PlaceDescriptor Describe(const std::vector<PlacePart>& parts,
                           const Eigen::Vector2d& center) const;

  // Views are a grid of so many by so many points, so far apart [m]. Every second one along both
  // axes, the middle one among them, is one of the options' coarser grid.
  int views_per_side() const { return 4 * options_.num_shifts() + 1; }
  double view_spacing_m() const { return 0.5 * options_.shift_m(); }
  // For the comparison of views.
  const BearingTransform& transform() const { return transform_; }

 private:
  PlaceDescriber(const proto::PlaceRecognitionOptions& options, PlaceChannels channels);

  BearingSpectrum LookFrom(const Eigen::Vector2d& shift,
                           const std::vector<PlaceLayer>& layers) const;
  void Scale(BearingSpectrum* spectrum) const;

  proto::PlaceRecognitionOptions options_;
  PlaceChannels channels_;
  BearingTransform transform_;
  std::vector<Eigen::Vector2d> directions_;  // unit vectors, by bearing
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_PLACE_DESCRIPTOR_H_
