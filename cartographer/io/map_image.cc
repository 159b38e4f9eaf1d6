// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_image.h"

#include <cstdint>
#include <vector>

#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/io/draw_page.h"
#include "cartographer/io/hidden_labels.h"
#include "cartographer/io/raster_frame.h"
#include "cartographer/io/raster_gaps.h"
#include "cartographer/io/raster_shading.h"
#include "cartographer/io/raster_shadow.h"
#include "cartographer/io/semantic_raster.h"

namespace cartographer::io {

absl::StatusOr<std::string> RenderMapImage(const map::Map& map,
                                           const proto::RenderOptions& options) {
  ASSIGN_OR_RETURN(const sensor::LabelMask hidden, HiddenLabels(options, map.labels));
  ASSIGN_OR_RETURN(
      const RasterFrame frame,
      FrameOf(map, hidden, {options.resolution_m(), options.max_side_px(), options.crop_share()}));
  SemanticRaster raster = ComposeRaster(map, hidden, frame);
  FillGaps(map.labels.WithRole(sensor::LabelRole::kGround), options.fill_gaps_m(), &raster);
  const std::vector<uint32_t> pixels =
      ShadeRaster(raster, map.labels, CastShadows(map, hidden, frame));
  ASSIGN_OR_RETURN(const Canvas canvas, DrawPage(map, options, raster, pixels));
  return canvas.ToPng();
}

absl::Status WriteMapImage(const map::Map& map, const proto::RenderOptions& options,
                           const std::string& path) {
  ASSIGN_OR_RETURN(const std::string bytes, RenderMapImage(map, options));
  return WriteFileAtomically(path, bytes);
}

}  // namespace cartographer::io
