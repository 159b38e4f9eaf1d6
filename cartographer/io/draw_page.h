// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_DRAW_PAGE_H_
#define CARTOGRAPHER_IO_DRAW_PAGE_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/io/draw_canvas.h"
#include "cartographer/io/proto/render_options.pb.h"
#include "cartographer/io/semantic_raster.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// Puts a raster's coloured pixels (raster_shading.h) on a page: the title above, the legend on the
// right, axes and scale bar below, trajectories and loop closures on top, each as the options say.
// Letters grow with the map. Without `draw_frame` the page is the map alone.
absl::StatusOr<Canvas> DrawPage(const map::Map& map, const proto::RenderOptions& options,
                                const SemanticRaster& raster, const std::vector<uint32_t>& pixels);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_DRAW_PAGE_H_
