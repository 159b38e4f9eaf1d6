// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_layers.h"

#include <cmath>
#include <limits>

namespace cartographer::pose_graph {
namespace {

// A point as the layers need it.
struct CellPoint {
  int cell;  // in row-major order
  int channel;
  float height_m;
};

// The points within the square, all channels and labels.
std::vector<CellPoint> PointsInSquare(const std::vector<PlacePart>& parts,
                                      const Eigen::Vector2d& center, const PlaceChannels& channels,
                                      int side_cells, double cell_m) {
  std::vector<CellPoint> points;
  size_t size = 0;
  for (const PlacePart& part : parts) size += part.cloud.size();
  points.reserve(size);
  const auto side = static_cast<float>(side_cells);
  for (const PlacePart& part : parts) {
    Eigen::Matrix<double, 3, 4> square_from_cloud = part.frame_from_cloud.Matrix();
    square_from_cloud.topRightCorner<2, 1>() -= center;
    square_from_cloud.topRows<2>() /= cell_m;
    square_from_cloud.topRightCorner<2, 1>().array() += 0.5 * side_cells;
    const Eigen::Matrix<float, 3, 4> transform = square_from_cloud.cast<float>();
    for (size_t i = 0; i < part.cloud.size(); ++i) {
      const Eigen::Vector3f point =
          transform.leftCols<3>() * part.cloud.positions[i] + transform.col(3);
      // Written so that what is not a number is outside, too.
      const bool inside = point.x() >= 0.f && point.x() < side && point.y() >= 0.f &&
                          point.y() < side && std::abs(point.z()) < 1e6f;
      if (!inside) continue;
      points.push_back({static_cast<int>(point.y()) * side_cells + static_cast<int>(point.x()),
                        channels.ChannelOf(part.cloud.labels[i]), point.z()});
    }
  }
  return points;
}

// Weights of the neighbours 0, 1, ... cells away.
std::vector<float> Kernel(double sigma_cells) {
  const int reach = static_cast<int>(std::ceil(3. * sigma_cells));
  std::vector<float> kernel(reach + 1);
  double sum = 0.;
  for (int i = 0; i <= reach; ++i) {
    const double value = i == 0 ? 1. : std::exp(-0.5 * i * i / (sigma_cells * sigma_cells));
    kernel[i] = static_cast<float>(value);
    sum += i == 0 ? value : 2. * value;
  }
  for (float& value : kernel) value /= static_cast<float>(sum);
  return kernel;
}

// Blurs along y; what is beyond the border is 0.
PlaceLayer BlurRows(const PlaceLayer& layer, const std::vector<float>& kernel) {
  PlaceLayer result = kernel[0] * layer;
  const auto side = layer.rows();
  for (int i = 1; i < std::min<int>(kernel.size(), side); ++i) {
    result.topRows(side - i) += kernel[i] * layer.bottomRows(side - i);
    result.bottomRows(side - i) += kernel[i] * layer.topRows(side - i);
  }
  return result;
}

PlaceLayer Blur(const PlaceLayer& layer, const std::vector<float>& kernel) {
  return BlurRows(BlurRows(layer, kernel).transpose(), kernel).transpose();
}

}  // namespace

std::vector<PlaceLayer> DrawPlaceLayers(const std::vector<PlacePart>& parts,
                                        const Eigen::Vector2d& center,
                                        const PlaceChannels& channels,
                                        const PlaceLayersOptions& options) {
  const int side_cells = 2 * static_cast<int>(std::ceil(options.reach_m / options.cell_m));
  const std::vector<CellPoint> points =
      PointsInSquare(parts, center, channels, side_cells, options.cell_m);
  std::vector<float> lowest(side_cells * side_cells, std::numeric_limits<float>::infinity());
  for (const CellPoint& point : points) {
    lowest[point.cell] = std::min(lowest[point.cell], point.height_m);
  }
  std::vector<PlaceLayer> layers(channels.size(), PlaceLayer::Zero(side_cells, side_cells));
  const auto min_height = static_cast<float>(options.min_height_m);
  for (const CellPoint& point : points) {
    if (point.channel == PlaceChannels::kNotUsed) continue;
    if (point.height_m - lowest[point.cell] < min_height) continue;
    layers[point.channel].data()[point.cell] += 1.f;
  }
  const auto cell_m2 = static_cast<float>(options.cell_m * options.cell_m);
  const std::vector<float> kernel = Kernel(options.blur_m / options.cell_m);
  for (int i = 0; i < channels.size(); ++i) {
    layers[i] = (layers[i] / (channels[i].saturation_hits * cell_m2)).min(1.f);
    layers[i] = Blur(layers[i], kernel);
  }
  return layers;
}

}  // namespace cartographer::pose_graph
