// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_descriptor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cartographer/common/status.h"

namespace cartographer::pose_graph {
namespace {

// Where a layer is sampled: between the cells (x, y) and (x + 1, y + 1), and how near to each.
struct Sample {
  int x, y;
  float part_x, part_y;
};

Sample SampleAt(const Eigen::Vector2d& point_m, double cell_m, int side_cells) {
  // In cells from the centre of the first one. Views do not look beyond the square.
  const Eigen::Array2d cells =
      (point_m.array() / cell_m + 0.5 * side_cells - 0.5).max(0.).min(side_cells - 1.001);
  const Eigen::Array2d whole = cells.floor();
  return {static_cast<int>(whole.x()), static_cast<int>(whole.y()),
          static_cast<float>(cells.x() - whole.x()), static_cast<float>(cells.y() - whole.y())};
}

float ValueAt(const PlaceLayer& layer, const Sample& sample) {
  const float* const row = &layer(sample.y, sample.x);
  const float* const next_row = row + layer.cols();
  const float here = row[0] + sample.part_x * (row[1] - row[0]);
  const float there = next_row[0] + sample.part_x * (next_row[1] - next_row[0]);
  return here + sample.part_y * (there - here);
}

}  // namespace

absl::StatusOr<PlaceDescriber> PlaceDescriber::Create(const proto::PlaceRecognitionOptions& options,
                                                      const sensor::LabelSet& labels) {
  ASSIGN_OR_RETURN(PlaceChannels channels, PlaceChannels::Create(options, labels));
  return PlaceDescriber(options, std::move(channels));
}

PlaceDescriber::PlaceDescriber(const proto::PlaceRecognitionOptions& options,
                               PlaceChannels channels)
    : options_(options), channels_(std::move(channels)), transform_(options.num_harmonics()) {
  for (int i = 0; i < transform_.num_bearings(); ++i) {
    const double bearing = 2. * M_PI * i / transform_.num_bearings();
    directions_.emplace_back(std::cos(bearing), std::sin(bearing));
  }
}

PlaceDescriptor PlaceDescriber::Describe(const std::vector<PlacePart>& parts,
                                         const Eigen::Vector2d& center) const {
  PlaceDescriptor result;
  result.center = center;
  PlaceLayersOptions layers_options;
  // So that views from the corners of the grid see all of their rings.
  layers_options.reach_m =
      options_.radius_m() + options_.num_shifts() * options_.shift_m() + options_.cell_m();
  layers_options.cell_m = options_.cell_m();
  layers_options.min_height_m = options_.min_height_m();
  layers_options.blur_m = options_.blur_m();
  const std::vector<PlaceLayer> layers = DrawPlaceLayers(parts, center, channels_, layers_options);
  const bool nothing = std::all_of(layers.begin(), layers.end(),
                                   [](const PlaceLayer& layer) { return (layer == 0.f).all(); });
  if (nothing) return result;
  const int reach = views_per_side() / 2;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      result.views.push_back(LookFrom(Eigen::Vector2d(x, y) * view_spacing_m(), layers));
    }
  }
  return result;
}

BearingSpectrum PlaceDescriber::LookFrom(const Eigen::Vector2d& shift,
                                         const std::vector<PlaceLayer>& layers) const {
  const int num_rings = options_.num_rings(), num_bearings = transform_.num_bearings();
  PlaceLayer values(channels_.size() * num_rings, num_bearings);
  for (int ring = 0; ring < num_rings; ++ring) {
    const double radius_m = (ring + 0.5) * options_.radius_m() / num_rings;
    // Products of two views then count every ring by its area.
    const auto root_of_area = static_cast<float>(std::sqrt(radius_m));
    for (int i = 0; i < num_bearings; ++i) {
      const Eigen::Vector2d point = shift + radius_m * directions_[i];
      const Sample sample =
          SampleAt(point, options_.cell_m(), static_cast<int>(layers.front().cols()));
      for (int channel = 0; channel < channels_.size(); ++channel) {
        values(channel * num_rings + ring, i) = root_of_area * ValueAt(layers[channel], sample);
      }
    }
  }
  BearingSpectrum spectrum = transform_.Transform(values);
  Scale(&spectrum);
  return spectrum;
}

void PlaceDescriber::Scale(BearingSpectrum* spectrum) const {
  const int num_rings = options_.num_rings();
  const int num_rows = channels_.size() * num_rings;
  std::vector<float> squared_norms(channels_.size(), 0.f);
  auto& harmonics = spectrum->harmonics;
  for (size_t i = 0; i < harmonics.size(); ++i) {
    squared_norms[i % num_rows / num_rings] +=
        (harmonics[i].real.square() + harmonics[i].imaginary.square()).sum();
  }
  float sum = 0.f;
  for (int channel = 0; channel < channels_.size(); ++channel) {
    if (squared_norms[channel] > 0.f) {
      sum += channels_[channel].weight * channels_[channel].weight;
    }
  }
  if (sum == 0.f) return;
  for (size_t i = 0; i < harmonics.size(); ++i) {
    const int channel = i % num_rows / num_rings;
    if (squared_norms[channel] == 0.f) continue;
    const float scale = channels_[channel].weight / std::sqrt(squared_norms[channel] * sum);
    harmonics[i].real *= scale;
    harmonics[i].imaginary *= scale;
  }
}

}  // namespace cartographer::pose_graph
