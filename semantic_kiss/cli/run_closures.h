// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_RUN_CLOSURES_H_
#define SEMANTIC_KISS_CLI_RUN_CLOSURES_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cartographer/map/map.h"
#include "cartographer/pose_graph/closure.h"
#include "cartographer/pose_graph/node_search.h"
#include "cartographer/slam/map_builder.h"
#include "nlohmann/json.hpp"
#include "semantic_kiss/evaluation/closure_errors.h"

namespace semantic_kiss::cli {

// The loop closures of a run, and how right they are where there is ground truth.
struct RunClosures {
  std::vector<cartographer::pose_graph::Closure> closures;
  cartographer::pose_graph::VerdictCounts verdicts;
  // The last one: of all closures, and those that came with an earlier map.
  cartographer::pose_graph::OptimizationReport optimization;
  // With ground truth, one for each closure, absent if it is with a drive that was there before;
  // else empty.
  std::vector<std::optional<evaluation::ClosureError>> errors;
  std::optional<evaluation::RevisitCoverage> coverage;
  // The nodes that were looked for and had candidates that became no closures: of each the one that
  // came furthest.
  std::map<cartographer::submap::NodeId, cartographer::pose_graph::NodeSearch> rejected;

  int NumFalse() const;
};

// `truth`: poses of the lidar, one for each scan or more; nullptr if there is none. `map` is what
// the builder handed out.
RunClosures GatherClosures(const cartographer::slam::MapBuilder& map_builder,
                           const cartographer::map::Map& map,
                           const std::vector<cartographer::transform::Rigid3d>* truth);

// The value of "loop_closures" in run.json, in the order in which they were accepted.
nlohmann::ordered_json ClosuresJson(const RunClosures& closures);

// The value of "closure_search": candidates by verdict, coverage, how the optimization went, and
// for each node with rejected candidates the one that came furthest.
nlohmann::ordered_json ClosureSearchJson(const RunClosures& closures);

// One line for people: "57 of 412 candidates accepted, none false; 93 % of 640 m revisited closed".
std::string ClosuresLine(const RunClosures& closures);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_RUN_CLOSURES_H_
