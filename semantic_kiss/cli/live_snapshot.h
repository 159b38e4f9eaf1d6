// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_LIVE_SNAPSHOT_H_
#define SEMANTIC_KISS_CLI_LIVE_SNAPSHOT_H_

#include "cartographer/slam/map_builder.h"
#include "semantic_kiss/cli/drive.h"
#include "semantic_kiss/live/snapshot.h"

namespace semantic_kiss::cli {

// What a drive has come to so far; what the loop over the scans alone knows (total, elapsed_s,
// error_m) is left to it. A walk over nodes and submaps, which copies no points.
live::Snapshot TakeSnapshot(const DriveRecord& record,
                            const cartographer::slam::MapBuilder& map_builder);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_LIVE_SNAPSHOT_H_
