// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/height_band.h"

#include "cartographer/registration/voxel_filter.h"

namespace cartographer::slam {

sensor::LabeledPointCloud CutHeightBand(const sensor::LabeledPointCloud& scan,
                                        const proto::HeightBandOptions& options) {
  const double min_squared = options.min_range_m() * options.min_range_m();
  const double max_squared = options.max_range_m() * options.max_range_m();
  sensor::LabeledPointCloud band;
  for (size_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3f& position = scan.positions[i];
    // Comparisons with NaN are false.
    const bool inside = position.z() >= options.min_z_m() && position.z() <= options.max_z_m() &&
                        position.squaredNorm() >= min_squared &&
                        position.squaredNorm() <= max_squared;
    if (!inside) continue;
    band.positions.push_back(position);
    band.labels.push_back(scan.labels[i]);
    band.certainties.push_back(scan.certainties[i]);
  }
  return registration::FilterByVoxel(band, options.voxel_size_m());
}

}  // namespace cartographer::slam
