// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_TRACED_SCAN_H_
#define SEMANTIC_KISS_CLI_TRACED_SCAN_H_

#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"
#include "cartographer/map/map.h"
#include "cartographer/slam/map_builder.h"
#include "cartographer/slam/scan_trace.h"

namespace semantic_kiss::cli {

// One scan's way through the stages: what --trace_scan asks for.
struct TracedScan {
  int number = 0;    // in its sequence
  int position = 0;  // among the scans of the drive
  bool is_node = false;
  cartographer::slam::ScanTrace steps;
};

// The value of --trace_scan. Errors name the part that is no number.
absl::StatusOr<std::set<int>> ScansToTrace(absl::string_view list);

// Fails unless all numbers are among the `count` of a drive that begins with the number `first`.
absl::Status CheckScansToTrace(const std::set<int>& numbers, int first, int count);

// Adds a scan to the map, as MapBuilder::AddScan() does, and writes down what every stage made of
// it, beginning with `reading_s`, what reading it took.
cartographer::slam::LocalResult AddTraced(const cartographer::sensor::LabeledScan& scan,
                                          double reading_s,
                                          cartographer::slam::MapBuilder* map_builder,
                                          TracedScan* traced);

// Appends what is known at the end of the drive alone: whether the scan's place was recognized, and
// where the map has it. `map` is what the builder handed out.
void CompleteTrace(const cartographer::slam::MapBuilder& map_builder,
                   const cartographer::map::Map& map, TracedScan* traced);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_TRACED_SCAN_H_
