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

constexpr uint8_t kGroundLevel = 11;
constexpr uint8_t kFilledLevel = 10;
constexpr uint8_t kUnlabeledLevel = 4;
constexpr uint8_t kOnlyUnlabeledLevel = 11;
// Of what stands on the ground: with the median of hits, and per doubling of it.
constexpr float kMedianLevel = 11.f;
constexpr float kLevelsPerDoubling = 1.5f;
constexpr float kMinLevel = 7.f;

std::vector<Label> InStackOrder(const LabelSet& labels, const LabelMask& hidden) {
  std::vector<Label> order;
  for (size_t i = 0; i < labels.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (!hidden.Contains(label) && label != kUnlabeled) order.push_back(label);
  }
  std::stable_sort(order.begin(), order.end(), [&](Label a, Label b) {
    return GroupOf(labels, a) < GroupOf(labels, b);
  });
  return order;
}

SemanticRaster RasterOf(Label label, const Map& map, const RasterFrame& frame) {
  LabelMask others;
  for (size_t i = 0; i < map.labels.size(); ++i) {
    if (Label{static_cast<uint8_t>(i)} != label) others.Insert(Label{static_cast<uint8_t>(i)});
  }
  return ComposeRaster(map, others, frame);
}

bool Occurs(Label label, const Map& map) {
  return std::any_of(map.submaps.begin(), map.submaps.end(), [&](const auto& entry) {
    const std::vector<Label> labels = entry.second.submap->grid.Labels();
    return std::find(labels.begin(), labels.end(), label) != labels.end();
  });
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

// `filled` is `seen` with gaps filled.
AlphaImage DrawGround(const SemanticRaster& seen, const SemanticRaster& filled, Label label,
                      Beneath* beneath) {
  AlphaImage image(seen.frame.width, seen.frame.height);
  for (size_t i = 0; i < seen.hits.size(); ++i) {
    if (beneath->IsBeatenBy(label, seen.hits[i], i)) {
      beneath->Put(label, seen.hits[i], i);
      image.levels[i] = kGroundLevel;
    } else if (filled.labels[i] == label && beneath->Bare(i)) {
      image.levels[i] = kFilledLevel;
    }
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

AlphaImage DrawMarks(const SemanticRaster& seen) {
  AlphaImage image(seen.frame.width, seen.frame.height);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (seen.hits[seen.IndexOf(column, row)] == 0.f) continue;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, image.height - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, image.width - 1); ++x) {
          image.Row(y)[x] = kOpaque;
        }
      }
    }
  }
  return image;
}

AlphaImage DrawUnlabeled(const SemanticRaster& seen, uint8_t level, const Beneath& beneath) {
  AlphaImage image(seen.frame.width, seen.frame.height);
  for (size_t i = 0; i < seen.hits.size(); ++i) {
    if (seen.hits[i] > 0.f && beneath.Bare(i)) image.levels[i] = level;
  }
  return image;
}

AlphaImage DrawLayer(Label label, const Map& map, const RasterFrame& frame, double fill_gaps_m,
                     Beneath* beneath) {
  const SemanticRaster seen = RasterOf(label, map, frame);
  const LayerGroup group = GroupOf(map.labels, label);
  if (group == LayerGroup::kCritical) return DrawMarks(seen);
  if (group != LayerGroup::kGround) return DrawObjects(seen, label, beneath);
  SemanticRaster filled = seen;
  LabelMask ground;
  ground.Insert(label);
  cartographer::io::FillGaps(ground, fill_gaps_m, &filled);
  return DrawGround(seen, filled, label, beneath);
}

}  // namespace

LayerGroup GroupOf(const LabelSet& labels, Label label) {
  if (labels.HasRole(label, LabelRole::kCritical)) return LayerGroup::kCritical;
  if (labels.HasRole(label, LabelRole::kMoving)) return LayerGroup::kMoving;
  if (labels.HasRole(label, LabelRole::kMovable)) return LayerGroup::kMovable;
  if (labels.HasRole(label, LabelRole::kUnlabeled)) return LayerGroup::kUnlabeled;
  if (labels.HasRole(label, LabelRole::kGround)) return LayerGroup::kGround;
  return LayerGroup::kStructure;
}

const char* NameOf(LayerGroup group) {
  switch (group) {
    case LayerGroup::kGround:
      return "Ground";
    case LayerGroup::kUnlabeled:
      return "Unlabeled";
    case LayerGroup::kStructure:
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
                     const std::function<void(Label, AlphaImage)>& take) {
  Beneath beneath(frame.size());
  bool labeled = false;
  const auto take_unless_empty = [&](Label label, AlphaImage image) {
    if (IsEmpty(image)) return;
    labeled = true;
    take(label, std::move(image));
  };
  for (const Label label : InStackOrder(map.labels, options.hidden)) {
    if (!Occurs(label, map)) continue;
    take_unless_empty(label, DrawLayer(label, map, frame, options.fill_gaps_m, &beneath));
  }
  if (options.hidden.Contains(kUnlabeled) || !Occurs(kUnlabeled, map)) return;
  take_unless_empty(kUnlabeled,
                    DrawUnlabeled(RasterOf(kUnlabeled, map, frame),
                                  labeled ? kUnlabeledLevel : kOnlyUnlabeledLevel, beneath));
}

}  // namespace semantic_kiss::report
