// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_PLACE_LAYERS_H_
#define CARTOGRAPHER_POSE_GRAPH_PLACE_LAYERS_H_

#include <Eigen/Core>
#include <vector>

#include "cartographer/pose_graph/place_channels.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// A cloud and where it stands in the frame in which a place is described, which must be level.
struct PlacePart {
  const sensor::LabeledPointCloud& cloud;
  transform::Rigid3d frame_from_cloud;
};

// A square from above: row y, column x.
using PlaceLayer = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct PlaceLayersOptions {
  double reach_m;       // half the side of the square, rounded up to whole cells
  double cell_m;        // > 0
  double min_height_m;  // points lower than this above the lowest one of their cell do not count
  double blur_m;        // standard deviation; 0: not blurred
};

// How full of a channel the cells around `center` are, in [0, 1], blurred, by channel: the points
// of a cell per m^2 over what makes it full, at most 1. That they are many plays no part beyond
// that: clouds are dense where the lidar passed and thin elsewhere. All layers are
// 2 ceil(reach / cell) cells wide, with `center` at the corner between the middle four. Points that
// are not finite are left out.
std::vector<PlaceLayer> DrawPlaceLayers(const std::vector<PlacePart>& parts,
                                        const Eigen::Vector2d& center,
                                        const PlaceChannels& channels,
                                        const PlaceLayersOptions& options);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_PLACE_LAYERS_H_
