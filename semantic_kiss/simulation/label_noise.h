// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_LABEL_NOISE_H_
#define SEMANTIC_KISS_SIMULATION_LABEL_NOISE_H_

#include <cstdint>

#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/scanner.h"

namespace semantic_kiss::simulation {

// Replaces the labels of a scan by what a network might have said, and sets the certainties.
//
// A thing, or a patch of ground or wall, is mistaken as a whole and for some scans on end; beside
// another class mistakes are more frequent and take that class. The chance of a mistake is drawn by
// patch and is known: the certainty is one minus it, so certainties are calibrated. Wrong labels
// are `share` of all points on average.
void AddLabelNoise(const proto::LabelNoiseOptions& options, uint64_t seed, int scan,
                   SimulatedScan* points);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_LABEL_NOISE_H_
