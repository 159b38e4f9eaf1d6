// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SCAN_PREVIEW_H_
#define SEMANTIC_KISS_SIMULATION_SCAN_PREVIEW_H_

#include <string>

#include "absl/status/status.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/simulation/simulation.h"

namespace semantic_kiss::simulation {

// Draws a scan as the lidar sees it, as a PNG: straight ahead in the middle, behind the car at both
// edges, a row of pixels a beam (or several). Three pictures below each other: labels in the set's
// colours, range (near bright, far dark), remission. Black: no return.
//   scan   number of the scan, in the drive (CHECKed)
absl::Status DrawScanPreview(const Simulation& simulation, int scan,
                             const cartographer::sensor::LabelSet& labels, const std::string& path);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SCAN_PREVIEW_H_
