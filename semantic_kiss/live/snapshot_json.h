// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LIVE_SNAPSHOT_JSON_H_
#define SEMANTIC_KISS_LIVE_SNAPSHOT_JSON_H_

#include <nlohmann/json.hpp>

#include "semantic_kiss/live/snapshot.h"

namespace semantic_kiss::live {

// "driving", "concluding", "done", "stopped".
const char* NameOf(Phase phase);

// {done, total, elapsed_s, error_m or null, memory_mib, nodes, submaps, outcomes {word: scans},
//  candidates, stages [{name, mean_ms, total_s}], path {x, y}, closures [[x, y, x, y]]}; positions
// in metres to the decimetre.
nlohmann::ordered_json SnapshotJson(const Snapshot& snapshot);

}  // namespace semantic_kiss::live

#endif  // SEMANTIC_KISS_LIVE_SNAPSHOT_JSON_H_
