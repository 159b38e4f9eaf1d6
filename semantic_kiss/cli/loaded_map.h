// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_LOADED_MAP_H_
#define SEMANTIC_KISS_CLI_LOADED_MAP_H_

#include <string>

#include "absl/status/statusor.h"
#include "cartographer/io/map_reader.h"
#include "cartographer/map/map.h"
#include "cartographer/sensor/label_set.h"

namespace semantic_kiss::cli {

// Reads a map that scans with labels of `labels` are to be compared with or added to.
// FailedPrecondition if its labels are others (a map without labels, such as Cartographer's own,
// fits all), if it has no submaps, or if trajectories after its own would have numbers that map
// files cannot have.
absl::StatusOr<cartographer::map::Map> LoadMapFor(const cartographer::sensor::LabelSet& labels,
                                                  const std::string& path,
                                                  const cartographer::io::MapParts& parts);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_LOADED_MAP_H_
