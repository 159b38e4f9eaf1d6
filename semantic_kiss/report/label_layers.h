// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_LABEL_LAYERS_H_
#define SEMANTIC_KISS_REPORT_LABEL_LAYERS_H_

#include <functional>

#include "cartographer/io/raster_frame.h"
#include "cartographer/map/map.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/report/alpha_image.h"

namespace semantic_kiss::report {

// What a label is to somebody who looks at a map, in the order in which layers lie upon each other.
enum class LayerGroup { kGround, kUnlabeled, kShadow, kStanding, kMovable, kMoving, kCritical };

// The group by the label's roles; of several groups the one that lies highest. Shadows are no
// label's (shadow_layers.h).
LayerGroup GroupOf(const cartographer::sensor::LabelSet& labels, cartographer::sensor::Label label);
// A heading: "Ground", "Movable", ...
const char* NameOf(LayerGroup group);

struct LabelLayersOptions {
  cartographer::sensor::LabelMask hidden;  // labels that get no layer
  double fill_gaps_m = 0.;                 // cartographer/io/raster_gaps.h, for ground labels
};

// Draws a picture for every label that the map's grids saw within `frame`, such that all of them
// upon each other, by group and then by label, show what was seen most in each pixel (as
// io::ComposeRaster() does), and that without those of what stands on the ground the ground shows:
//   - ground labels share the ground, gaps between the rings filled, whatever stands there,
//   - a label of what stands is drawn where it has more hits than each of the labels below it (as
//     many, if it is the smaller label),
//   - unlabeled hits are drawn, faintly, where there are no others; in a map that has only such, as
//     what stands,
//   - critical labels, often a pixel, are drawn wherever they were seen, and on the four pixels
//     around.
// More hits, compared with the label's median, make a pixel of what stands more opaque.
//
// `take` gets the pictures one after another, since all of them at once would take much memory:
// kUnlabeled's last, empty ones not at all.
void DrawLabelLayers(const cartographer::map::Map& map, const cartographer::io::RasterFrame& frame,
                     const LabelLayersOptions& options,
                     const std::function<void(cartographer::sensor::Label, AlphaImage)>& take);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_LABEL_LAYERS_H_
