// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_JSON_H_
#define SEMANTIC_KISS_CLI_RUN_JSON_H_

#include <nlohmann/json.hpp>

#include "semantic_kiss/cli/run_result.h"

namespace semantic_kiss::cli {

// The content of run.json, keys in this order:
//   version, config            program, and resolved configuration as Lua
//   scans, scans_available     fewer than available if the run was stopped
//   scan_points                of all scans together, as read
//   stages                     {stage: {median_ms, p95_ms, total_s}}
//   scans_per_second           of the drive, reading included
//   peak_memory_mib
//   odometry_outcomes          {outcome: number of scans}
//   unknown_label_ids          {id: number of points}
//   map                        {nodes, submaps, constraints}
//   loop_closures              []
//   metrics                    {rte_percent, rte_deg_per_m, ate_3d_m, ate_2d_m}, null if unknown
//   last_pose                  {error_m, error_deg, height_error_m}, null without ground truth
//   notes                      what to know about the input
nlohmann::ordered_json RunJson(const RunResult& result);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_JSON_H_
