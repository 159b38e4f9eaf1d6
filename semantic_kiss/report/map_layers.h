// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_MAP_LAYERS_H_
#define SEMANTIC_KISS_REPORT_MAP_LAYERS_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/io/proto/render_options.pb.h"
#include "cartographer/io/raster_frame.h"
#include "cartographer/map/map.h"
#include "semantic_kiss/report/layer_tiles.h"
#include "semantic_kiss/report/proto/report_options.pb.h"

namespace semantic_kiss::report {

struct MapLayer {
  std::string name;   // of the label; of shadows: the group that casts them
  std::string group;  // what it stands under (label_layers.h)
  cartographer::sensor::Color color;
  std::vector<LayerTile> tiles;
};

// A map from above, taken apart into its labels and cut into tiles.
struct MapLayers {
  cartographer::io::RasterFrame frame;  // of level 0
  int halvings = 0;                     // levels besides
  int tile_side_px = 0;
  std::vector<MapLayer> layers;  // the lowest first
};

// Takes apart maps that are looked at side by side: all get the same resolution, fine enough for
// none to be larger than the options allow. Of `image` count `hide`, `show`, `crop_share` and
// `fill_gaps_m`. At least one map (CHECKed). Parallel; the result does not depend on it. Errors are
// those of io::FrameOf() and io::HiddenLabels().
absl::StatusOr<std::vector<MapLayers>> TakeApart(
    const std::vector<const cartographer::map::Map*>& maps,
    const cartographer::io::proto::RenderOptions& image, const proto::ReportOptions& options);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_MAP_LAYERS_H_
