// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/occupancy_grid.h"

#include <cmath>
#include <filesystem>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/io/hidden_labels.h"
#include "cartographer/io/raster_frame.h"
#include "cartographer/io/raster_gaps.h"
#include "cartographer/io/semantic_raster.h"

namespace cartographer::io {
namespace {

// As map_server reads a picture with the YAML below: occupied above 0.65, free below 0.196 of
// (255 - value) / 255.
constexpr char kOccupied = 0;
constexpr char kFree = static_cast<char>(254);
constexpr char kUnknown = static_cast<char>(205);
constexpr const char* kThresholds = "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

absl::StatusOr<RasterFrame> FrameFor(const map::Map& map, const sensor::LabelMask& hidden,
                                     const proto::RenderOptions& options) {
  const double wanted_m =
      options.resolution_m() > 0. ? options.resolution_m() : FinestResolution_m(map);
  ASSIGN_OR_RETURN(const RasterFrame frame,
                   FrameOf(map, hidden, {wanted_m, options.max_side_px(), 0.}));
  if (frame.resolution_m == wanted_m || options.resolution_m() == 0.) return frame;
  // Three digits, rounded up so that they suffice.
  const double step_m = std::pow(10., std::floor(std::log10(frame.resolution_m)) - 2.);
  return absl::InvalidArgumentError(absl::StrFormat(
      "resolution: with pixels of %g m the map is larger than %d pixels a side (max_side_px); give "
      "%.3g m or more",
      wanted_m, options.max_side_px(), std::ceil(frame.resolution_m / step_m) * step_m));
}

std::string PixelsOf(const SemanticRaster& raster, const sensor::LabelMask& ground) {
  std::string pixels(raster.labels.size(), kUnknown);
  for (size_t i = 0; i < pixels.size(); ++i) {
    // Filled gaps have a label, but no hits.
    if (ground.Contains(raster.labels[i])) {
      pixels[i] = kFree;
    } else if (raster.hits[i] > 0.f) {
      pixels[i] = kOccupied;
    }
  }
  return pixels;
}

std::string YamlFor(const RasterFrame& frame, const std::string& pgm_name) {
  const Eigen::Vector2d lower_left = frame.MapFromPixel({0., double(frame.height)});
  return absl::StrFormat(
      "image: \"%s\"\nmode: trinary\nresolution: %.10g\norigin: [%.10g, %.10g, 0]\nnegate: 0\n%s",
      absl::Utf8SafeCEscape(pgm_name), frame.resolution_m, lower_left.x(), lower_left.y(),
      kThresholds);
}

}  // namespace

absl::StatusOr<OccupancyGrid> DrawOccupancyGrid(const map::Map& map,
                                                const proto::RenderOptions& options,
                                                const std::string& pgm_name) {
  ASSIGN_OR_RETURN(const sensor::LabelMask hidden, LabelsHiddenFromOccupancy(options, map.labels));
  ASSIGN_OR_RETURN(const RasterFrame frame, FrameFor(map, hidden, options));
  SemanticRaster raster = ComposeRaster(map, hidden, frame);
  const sensor::LabelMask& ground = map.labels.WithRole(sensor::LabelRole::kGround);
  FillGaps(ground, options.fill_gaps_m(), &raster);
  return OccupancyGrid{
      absl::StrCat("P5\n", frame.width, " ", frame.height, "\n255\n", PixelsOf(raster, ground)),
      YamlFor(frame, pgm_name)};
}

absl::Status WriteOccupancyGrid(const map::Map& map, const proto::RenderOptions& options,
                                const std::string& pgm_path) {
  const std::filesystem::path path(pgm_path);
  ASSIGN_OR_RETURN(const OccupancyGrid grid,
                   DrawOccupancyGrid(map, options, path.filename().string()));
  const std::string yaml_path = std::filesystem::path(path).replace_extension(".yaml").string();
  // The file that ROS opens, which names the other, comes last.
  AtomicFileSet pair;
  RETURN_IF_ERROR(WriteFileAtomically({pgm_path, &pair}, grid.pgm));
  RETURN_IF_ERROR(WriteFileAtomically({yaml_path, &pair}, grid.yaml));
  return pair.Commit();
}

}  // namespace cartographer::io
