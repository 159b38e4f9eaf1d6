// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_MAP_INFO_H_
#define SEMANTIC_KISS_CLI_MAP_INFO_H_

#include <nlohmann/json.hpp>
#include <string>

#include "cartographer/io/map_summary.h"

namespace semantic_kiss::cli {

// A map file's summary for people.
std::string MapInfoText(const cartographer::io::MapSummary& summary);

// The same for scripts, keys in this order: file_bytes, format_version, made_by_us, trajectories,
// constraints {intra, inter}, unsupported_submaps, label_set, labels {name: {hits, submap_points,
// node_points}} of labels that occur, node_bounds_m and grid_bounds_m {min, max} or null, history,
// configuration, records.
nlohmann::ordered_json MapInfoJson(const cartographer::io::MapSummary& summary);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_MAP_INFO_H_
