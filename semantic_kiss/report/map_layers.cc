// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/map_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cartographer/common/status.h"
#include "cartographer/io/hidden_labels.h"
#include "cartographer/io/raster_shading.h"
#include "glog/logging.h"
#include "semantic_kiss/report/label_layers.h"
#include "semantic_kiss/report/shadow_layers.h"

namespace semantic_kiss::report {
namespace {

namespace io = cartographer::io;
using cartographer::map::Map;
using cartographer::sensor::kUnlabeled;
using cartographer::sensor::Label;
using cartographer::sensor::LabelMask;

// Coarsening by the ratio of sizes alone would miss the limit by a little, again and again.
constexpr double kCoarseningMargin = 1.1;

// A map with what of it is not to be drawn.
struct Subject {
  const Map* map;
  LabelMask hidden;
  io::RasterFrame frame;
};

absl::StatusOr<std::vector<Subject>> SubjectsOf(const std::vector<const Map*>& maps,
                                                const io::proto::RenderOptions& image) {
  std::vector<Subject> subjects;
  for (const Map* map : maps) {
    ASSIGN_OR_RETURN(const LabelMask hidden, io::HiddenLabels(image, map->labels));
    subjects.push_back({map, hidden, {}});
  }
  return subjects;
}

// Frames all subjects; returns the coarsest resolution that came out.
absl::StatusOr<double> FrameAll(const io::RasterFrameOptions& options,
                                std::vector<Subject>* subjects) {
  double coarsest_m = 0.;
  for (Subject& subject : *subjects) {
    ASSIGN_OR_RETURN(subject.frame, io::FrameOf(*subject.map, subject.hidden, options));
    coarsest_m = std::max(coarsest_m, subject.frame.resolution_m);
  }
  return coarsest_m;
}

// Frames all of one resolution: `resolution_m` or coarser.
absl::Status FrameAlike(io::RasterFrameOptions options, std::vector<Subject>* subjects) {
  ASSIGN_OR_RETURN(options.resolution_m, FrameAll(options, subjects));
  return FrameAll(options, subjects).status();
}

// Layers as they are drawn, each with where it belongs.
class LayerStack {
 public:
  LayerStack(int halvings, int tile_side) : halvings_(halvings), tile_side_(tile_side) {}

  void Add(const std::string& name, LayerGroup group, AlphaImage image, const Ink& ink) {
    layers_.push_back({group,
                       {name, NameOf(group), ink.color,
                        CutIntoTiles(std::move(image), halvings_, tile_side_, ink)}});
  }

  bool empty() const { return layers_.empty(); }

  // The lowest first.
  std::vector<MapLayer> Take() {
    std::stable_sort(layers_.begin(), layers_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<MapLayer> result;
    for (auto& layer : layers_) result.push_back(std::move(layer.second));
    return result;
  }

 private:
  const int halvings_, tile_side_;
  std::vector<std::pair<LayerGroup, MapLayer>> layers_;
};

void AddShadows(const Subject& subject, LayerStack* stack) {
  for (const LayerGroup group : {LayerGroup::kStanding, LayerGroup::kMovable}) {
    AlphaImage image = DrawShadows(*subject.map, subject.hidden, group, subject.frame);
    if (IsEmpty(image)) continue;
    stack->Add(NameOf(group), LayerGroup::kShadow, std::move(image), {{0, 0, 0}, kShadowOpacity});
  }
}

MapLayers Draw(const Subject& subject, double fill_gaps_m, int tile_side) {
  MapLayers result;
  result.frame = subject.frame;
  result.halvings = NumHalvings(subject.frame.width, subject.frame.height, tile_side);
  result.tile_side_px = tile_side;
  LayerStack stack(result.halvings, tile_side);
  const auto& labels = subject.map->labels;
  DrawLabelLayers(*subject.map, subject.frame, {subject.hidden, fill_gaps_m},
                  [&](Label label, AlphaImage image) {
                    // It comes last: if it is alone, it has to tell everything.
                    const bool alone = label == kUnlabeled && stack.empty();
                    stack.Add(labels.Name(label), GroupOf(labels, label), std::move(image),
                              {alone ? io::UnlabeledColor(false) : labels.ColorOf(label)});
                  });
  AddShadows(subject, &stack);
  result.layers = stack.Take();
  return result;
}

double Megabytes(const std::vector<MapLayers>& maps) {
  double bytes = 0.;
  for (const MapLayers& map : maps) {
    for (const MapLayer& layer : map.layers) {
      for (const LayerTile& tile : layer.tiles) bytes += tile.png.size();
    }
  }
  return bytes / 1e6;
}

}  // namespace

absl::StatusOr<std::vector<MapLayers>> TakeApart(const std::vector<const Map*>& maps,
                                                 const io::proto::RenderOptions& image,
                                                 const proto::ReportOptions& options) {
  CHECK(!maps.empty());
  ASSIGN_OR_RETURN(std::vector<Subject> subjects, SubjectsOf(maps, image));
  double resolution_m = options.resolution_m();
  if (resolution_m == 0.) {
    resolution_m = std::numeric_limits<double>::infinity();
    for (const Map* map : maps) resolution_m = std::min(resolution_m, io::FinestResolution_m(*map));
  }
  if (!std::isfinite(resolution_m)) resolution_m = 0.;  // no grids at all: FrameOf() says so
  while (true) {
    RETURN_IF_ERROR(
        FrameAlike({resolution_m, options.max_side_px(), image.crop_share()}, &subjects));
    std::vector<MapLayers> result;
    for (const Subject& subject : subjects) {
      result.push_back(Draw(subject, image.fill_gaps_m(), options.tile_side_px()));
    }
    const double excess = Megabytes(result) / options.max_pictures_mb();
    const io::RasterFrame& frame = subjects.front().frame;
    if (excess <= 1. || std::max(frame.width, frame.height) <= options.tile_side_px()) {
      return result;
    }
    resolution_m = frame.resolution_m * std::sqrt(excess) * kCoarseningMargin;
  }
}

}  // namespace semantic_kiss::report
