// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_ODOMETRY_PREPROCESSING_H_
#define SEMANTIC_KISS_ODOMETRY_PREPROCESSING_H_

#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/se3.h"
#include "semantic_kiss/odometry/proto/odometry_options.pb.h"

namespace semantic_kiss::odometry {

// What became of a scan's points; the four counts add up to the scan's size.
struct PreprocessingCounts {
  size_t kept = 0;
  size_t not_finite = 0;    // NaN or infinite coordinates
  size_t out_of_range = 0;  // not within (min_range, max_range), after deskewing
  size_t moving = 0;        // of a class in `dropped_labels`, and in range
};

struct PreprocessedScan {
  // Positions, labels and certainties of the points that are kept, in their original order. Labels
  // end at `label_max_range_m`.
  cartographer::sensor::LabeledPointCloud points;
  PreprocessingCounts counts;
  bool deskewed = false;
};

// Deskews a scan and drops the points that cannot be used. `motion` is the twist of the sensor
// during the sweep (see SweepMotion); it matters only with deskewing.
PreprocessedScan Preprocess(const cartographer::sensor::LabeledPointCloud& scan,
                            const cartographer::transform::Twist& motion,
                            const cartographer::sensor::LabelMask& dropped_labels,
                            const proto::PreprocessingOptions& options);

}  // namespace semantic_kiss::odometry

#endif  // SEMANTIC_KISS_ODOMETRY_PREPROCESSING_H_
