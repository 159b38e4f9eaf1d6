// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_PREVIEW_H_
#define SEMANTIC_KISS_SIMULATION_PREVIEW_H_

#include <string>

#include "absl/status/status.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/simulation/simulation.h"

namespace semantic_kiss::simulation {

// Draws the town from above as a PNG, in the label set's colours (classes that it does not list are
// grey), with the route. At most 4000 pixels wide and high.
absl::Status DrawPreview(const Simulation& simulation, const cartographer::sensor::LabelSet& labels,
                         const std::string& path);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_PREVIEW_H_
