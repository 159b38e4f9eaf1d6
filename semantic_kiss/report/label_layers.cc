// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/label_layers.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cartographer/io/raster_gaps.h"
#include "cartographer/io/semantic_raster.h"
#include "glog/logging.h"

namespace semantic_kiss::report {
namespace {

using cartographer::io::ComposeRaster;
using cartographer::io::RasterFrame;
using cartographer::io::SemanticRaster;
using cartographer::map::Map;
using cartographer::sensor::kUnlabeled;
using cartographer::sensor::Label;
using cartographer::sensor::LabelMask;
using cartographer::sensor::LabelRole;
using cartographer::sensor::LabelSet;
using Take = std::function<void(Label, AlphaImage)>;

constexpr uint8_t kGroundLevel = 11;
constexpr uint8_t kUnlabeledLevel = 4;
// Of what stands on the ground: with the median of hits, and per doubling of it.
constexpr float kMedianLevel = 11.f;
constexpr float kLevelsPerDoubling = 1.5f;
constexpr float kMinLevel = 7.f;

SemanticRaster RasterOf(const LabelMask& shown, const Map& map, const RasterFrame& frame) {
  LabelMask hidden;
  for (size_t i = 0; i < map.labels.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (!shown.Contains(label)) hidden.Insert(label);
  }
  return ComposeRaster(map, hidden, frame);
}

SemanticRaster RasterOf(Label label, const Map& map, const RasterFrame& frame) {
  LabelMask shown;
  shown.Insert(label);
  return RasterOf(shown, map, frame);
}

bool Occurs(Label label, const Map& map) {
  return std::any_of(map.submaps.begin(), map.submaps.end(), [&](const auto& entry) {
    const std::vector<Label> labels = entry.second.submap->grid.Labels();
    return std::find(labels.begin(), labels.end(), label) != labels.end();
  });
}

// The labels that the map has and that are not hidden, the lowest first.
std::vector<Label> InStackOrder(const Map& map, const LabelMask& hidden) {
  std::vector<Label> order;
  for (size_t i = 0; i < map.labels.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (!hidden.Contains(label) && Occurs(label, map)) order.push_back(label);
  }
  std::stable_sort(order.begin(), order.end(), [&](Label a, Label b) {
    return GroupOf(map.labels, a) < GroupOf(map.labels, b);
  });
  return order;
}

// Of the pixels that were hit; 1 if there are none.
float MedianHits(const SemanticRaster& raster) {
  std::vector<float> hits;
  std::copy_if(raster.hits.begin(), raster.hits.end(), std::back_inserter(hits),
               [](float value) { return value > 0.f; });
  if (hits.empty()) return 1.f;
  const auto middle = hits.begin() + hits.size() / 2;
  std::nth_element(hits.begin(), middle, hits.end());
  return *middle;
}

// What has been drawn so far: the strongest label of each pixel.
class Beneath {
 public:
  explicit Beneath(size_t size) : labels_(size, kUnlabeled), hits_(size, 0.f) {}

  bool IsBeatenBy(Label label, float hits, size_t i) const {
    return hits > hits_[i] || (hits == hits_[i] && hits > 0.f && label < labels_[i]);
  }
  void Put(Label label, float hits, size_t i) {
    labels_[i] = label;
    hits_[i] = hits;
  }
  bool Bare(size_t i) const { return hits_[i] == 0.f; }

 private:
  std::vector<Label> labels_;
  std::vector<float> hits_;
};

// What `ground`, all ground labels together with gaps filled, shows of one of them.
AlphaImage DrawGround(const SemanticRaster& ground, Label label, Beneath* beneath) {
  AlphaImage image(ground.frame.width, ground.frame.height);
  for (size_t i = 0; i < ground.hits.size(); ++i) {
    if (ground.labels[i] != label) continue;
    if (beneath->IsBeatenBy(label, ground.hits[i], i)) beneath->Put(label, ground.hits[i], i);
    image.levels[i] = kGroundLevel;
  }
  return image;
}

AlphaImage DrawObjects(const SemanticRaster& seen, Label label, Beneath* beneath) {
  AlphaImage image(seen.frame.width, seen.frame.height);
  const float median = MedianHits(seen);
  for (size_t i = 0; i < seen.hits.size(); ++i) {
    if (!beneath->IsBeatenBy(label, seen.hits[i], i)) continue;
    beneath->Put(label, seen.hits[i], i);
    const float level = kMedianLevel + kLevelsPerDoubling * std::log2(seen.hits[i] / median);
    image.levels[i] = static_cast<uint8_t>(
        std::lround(std::clamp(level, kMinLevel, static_cast<float>(kOpaque))));
  }
  return image;
}

// Every pixel that was hit becomes a cross of five.
AlphaImage DrawMarks(const SemanticRaster& seen) {
  AlphaImage image(seen.frame.width, seen.frame.height);
  const auto mark = [&](int column, int row) {
    if (column < 0 || row < 0 || column >= image.width || row >= image.height) return;
    image.Row(row)[column] = kOpaque;
  };
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (seen.hits[seen.IndexOf(column, row)] == 0.f) continue;
      for (const int step : {-1, 0, 1}) {
        mark(column + step, row);
        mark(column, row + step);
      }
    }
  }
  return image;
}

AlphaImage DrawUnlabeled(const SemanticRaster& seen, const Beneath& beneath) {
  AlphaImage image(seen.frame.width, seen.frame.height);
  for (size_t i = 0; i < seen.hits.size(); ++i) {
    if (seen.hits[i] > 0.f && beneath.Bare(i)) image.levels[i] = kUnlabeledLevel;
  }
  return image;
}

// All that drawing needs and leaves behind.
struct Drawing {
  const Map& map;
  const RasterFrame& frame;
  const std::vector<Label> order;
  Beneath beneath;
};

void DrawGroundLayers(double fill_gaps_m, Drawing* drawing, const Take& take) {
  LabelMask ground;
  for (const Label label : drawing->order) {
    if (GroupOf(drawing->map.labels, label) == LayerGroup::kGround) ground.Insert(label);
  }
  if (ground.Empty()) return;
  SemanticRaster raster = RasterOf(ground, drawing->map, drawing->frame);
  cartographer::io::FillGaps(ground, fill_gaps_m, &raster);
  for (const Label label : drawing->order) {
    if (ground.Contains(label)) take(label, DrawGround(raster, label, &drawing->beneath));
  }
}

void DrawStandingLayers(Drawing* drawing, const Take& take) {
  for (const Label label : drawing->order) {
    const LayerGroup group = GroupOf(drawing->map.labels, label);
    if (group == LayerGroup::kGround || group == LayerGroup::kUnlabeled) continue;
    const SemanticRaster seen = RasterOf(label, drawing->map, drawing->frame);
    take(label, group == LayerGroup::kCritical ? DrawMarks(seen)
                                               : DrawObjects(seen, label, &drawing->beneath));
  }
}

}  // namespace

LayerGroup GroupOf(const LabelSet& labels, Label label) {
  if (labels.HasRole(label, LabelRole::kCritical)) return LayerGroup::kCritical;
  if (labels.HasRole(label, LabelRole::kMoving)) return LayerGroup::kMoving;
  if (labels.HasRole(label, LabelRole::kMovable)) return LayerGroup::kMovable;
  if (labels.HasRole(label, LabelRole::kUnlabeled)) return LayerGroup::kUnlabeled;
  if (labels.HasRole(label, LabelRole::kGround)) return LayerGroup::kGround;
  return LayerGroup::kStanding;
}

const char* NameOf(LayerGroup group) {
  switch (group) {
    case LayerGroup::kGround:
      return "Ground";
    case LayerGroup::kUnlabeled:
      return "Unlabeled";
    case LayerGroup::kShadow:
      return "Shadows";
    case LayerGroup::kStanding:
      return "Standing";
    case LayerGroup::kMovable:
      return "Movable";
    case LayerGroup::kMoving:
      return "Moving";
    case LayerGroup::kCritical:
      return "Landmarks";
  }
  LOG(FATAL) << "unknown group " << static_cast<int>(group);
}

void DrawLabelLayers(const Map& map, const RasterFrame& frame, const LabelLayersOptions& options,
                     const Take& take) {
  bool labeled = false;
  const auto take_unless_empty = [&](Label label, AlphaImage image) {
    if (IsEmpty(image)) return;
    labeled = true;
    take(label, std::move(image));
  };
  Drawing drawing{map, frame, InStackOrder(map, options.hidden), Beneath(frame.size())};
  DrawGroundLayers(options.fill_gaps_m, &drawing, take_unless_empty);
  DrawStandingLayers(&drawing, take_unless_empty);
  const auto& order = drawing.order;
  if (std::find(order.begin(), order.end(), kUnlabeled) == order.end()) return;
  const SemanticRaster seen = RasterOf(kUnlabeled, map, frame);
  take_unless_empty(kUnlabeled, labeled ? DrawUnlabeled(seen, drawing.beneath)
                                        : DrawObjects(seen, kUnlabeled, &drawing.beneath));
}

}  // namespace semantic_kiss::report
