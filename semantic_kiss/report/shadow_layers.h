// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_SHADOW_LAYERS_H_
#define SEMANTIC_KISS_REPORT_SHADOW_LAYERS_H_

#include "cartographer/io/raster_frame.h"
#include "cartographer/map/map.h"
#include "semantic_kiss/report/alpha_image.h"
#include "semantic_kiss/report/label_layers.h"

namespace semantic_kiss::report {

// What a shadow that takes all light takes of the colours beneath.
inline constexpr double kShadowOpacity = 0.4;

// The shadows on the ground (cartographer/io/raster_shadow.h) of what stands, if `group` is
// kStanding, or of what is movable or moves, if it is kMovable: two pictures, since shadows are to
// go with what casts them. Labels in `hidden` cast none. Empty without clouds.
AlphaImage DrawShadows(const cartographer::map::Map& map,
                       const cartographer::sensor::LabelMask& hidden, LayerGroup group,
                       const cartographer::io::RasterFrame& frame);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_SHADOW_LAYERS_H_
