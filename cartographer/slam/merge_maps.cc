// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/merge_maps.h"

#include <algorithm>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/map/renumber.h"
#include "cartographer/map/trajectories.h"
#include "cartographer/slam/graph_of_map.h"

namespace cartographer::slam {
namespace {

absl::Status NotJoined(const pose_graph::VerdictCounts& verdicts) {
  const std::string found =
      absl::StrJoin(verdicts, ", ", [](std::string* out, const auto& verdict) {
        absl::StrAppend(out, verdict.second, " ", verdict.first);
      });
  return absl::FailedPreconditionError(
      absl::StrCat("no place of the one map was recognized in the other, so nothing joins them",
                   found.empty() ? "" : absl::StrCat(" (candidates: ", found, ")")));
}

}  // namespace

absl::StatusOr<MergedMap> MergeMaps(const map::Map& first, map::Map second,
                                    const sensor::LabelSet& labels,
                                    std::unique_ptr<pose_graph::PoseGraph> pose_graph) {
  second = map::Renumbered(std::move(second), NextTrajectoryId(first));
  const std::set<int> ids_of_second = map::TrajectoriesOf(second);
  pose_graph->AddMap(GraphOf(first));
  pose_graph->AddMap(GraphOf(second));
  MergedMap merged;
  pose_graph->SearchTrajectories(ids_of_second, &merged.stage_times);
  merged.closures = pose_graph->closures();
  merged.verdicts = pose_graph->verdicts();
  if (merged.closures.empty()) return NotJoined(merged.verdicts);
  merged.map = MapOf(pose_graph->Release(), labels);
  merged.map.configuration_lua = first.configuration_lua;
  merged.map.history = first.history;
  merged.map.history.insert(merged.map.history.end(), second.history.begin(), second.history.end());
  return merged;
}

}  // namespace cartographer::slam
