// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_RASTER_SHADING_H_
#define CARTOGRAPHER_IO_RASTER_SHADING_H_

#include <cstdint>
#include <vector>

#include "cartographer/io/semantic_raster.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::io {

// Behind everything: what was never seen.
inline constexpr sensor::Color kBackgroundColor{247, 246, 243};
// Around the marks of critical labels.
inline constexpr sensor::Color kRimColor{40, 36, 32};

// The even colour of a label in pictures, before hits and shadows change it: the label set's own,
// toned down where it covers the ground, so that what stands on it shows.
sensor::Color BaseColor(const sensor::LabelSet& labels, sensor::Label label);

// The same for kUnlabeled: faint beside labels, dark in a map that has none.
sensor::Color UnlabeledColor(bool beside_labels);

// Colours the raster: 0xffRRGGBB, row by row.
//   - Ground labels are even (paler where a gap was filled); other labels become darker and fuller
//     the more hits a pixel has, relative to the label's median, so that facades are crisp.
//   - Critical labels (poles, signs) are a pixel or two: they get a mark of at least 3 pixels with
//     a dark rim.
//   - Unlabeled hits are faint beside labeled ones, dark in a map that has no labels.
//   - `shadow` (raster_shadow.h; one value a pixel) darkens the ground and the background.
std::vector<uint32_t> ShadeRaster(const SemanticRaster& raster, const sensor::LabelSet& labels,
                                  const std::vector<float>& shadow);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_RASTER_SHADING_H_
