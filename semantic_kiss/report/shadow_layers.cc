// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/shadow_layers.h"

#include <cmath>
#include <vector>

#include "cartographer/io/raster_shadow.h"
#include "glog/logging.h"

namespace semantic_kiss::report {
namespace {

using cartographer::sensor::Label;
using cartographer::sensor::LabelMask;

// Landmarks stay, so their shadows belong to what stands.
LayerGroup ShadowGroupOf(LayerGroup group) {
  const bool leaves = group == LayerGroup::kMovable || group == LayerGroup::kMoving;
  return leaves ? LayerGroup::kMovable : LayerGroup::kStanding;
}

}  // namespace

AlphaImage DrawShadows(const cartographer::map::Map& map, const LabelMask& hidden, LayerGroup group,
                       const cartographer::io::RasterFrame& frame) {
  CHECK(group == LayerGroup::kStanding || group == LayerGroup::kMovable);
  LabelMask without = hidden;
  for (size_t i = 0; i < map.labels.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (ShadowGroupOf(GroupOf(map.labels, label)) != group) without.Insert(label);
  }
  const std::vector<float> shadow = cartographer::io::CastShadows(map, without, frame);
  AlphaImage image(frame.width, frame.height);
  for (size_t i = 0; i < shadow.size(); ++i) {
    image.levels[i] = static_cast<uint8_t>(std::lround(shadow[i] * kOpaque));
  }
  return image;
}

}  // namespace semantic_kiss::report
