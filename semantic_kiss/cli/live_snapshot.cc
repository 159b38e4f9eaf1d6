// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/live_snapshot.h"

#include <numeric>

#include "semantic_kiss/cli/resident_memory.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::pose_graph::Graph;
using cartographer::slam::MapBuilder;

std::vector<live::Snapshot::Stage> StagesOf(const StageTimes& times) {
  std::vector<live::Snapshot::Stage> stages;
  for (const auto& [name, durations_ms] : times.durations_ms()) {
    const double total_ms = std::accumulate(durations_ms.begin(), durations_ms.end(), 0.);
    stages.push_back({name, total_ms / durations_ms.size(), total_ms / 1e3});
  }
  return stages;
}

void AddClosures(const MapBuilder& map_builder, live::Snapshot* snapshot) {
  const Graph& graph = map_builder.graph();
  for (const auto& closure : map_builder.closures()) {
    snapshot->closures.push_back(
        {graph.nodes.at(closure.constraint.node_id).map_from_node.translation().head<2>(),
         graph.submaps.at(closure.constraint.submap_id).map_from_submap.translation().head<2>()});
  }
}

}  // namespace

live::Snapshot TakeSnapshot(const DriveRecord& record, const MapBuilder& map_builder) {
  live::Snapshot snapshot;
  snapshot.done = record.num_scans;
  snapshot.memory_mib = ResidentMemory_mib();
  snapshot.outcomes = record.outcomes;
  snapshot.stages = StagesOf(record.stage_times);
  for (const auto& [verdict, count] : map_builder.closure_verdicts()) {
    snapshot.num_candidates += count;
  }
  const Graph& graph = map_builder.graph();
  for (const auto& [id, node] : graph.nodes) {
    if (id.trajectory_id != map_builder.trajectory_id()) continue;
    snapshot.path.push_back(node.map_from_node.translation().head<2>());
  }
  snapshot.num_nodes = static_cast<int>(snapshot.path.size());
  for (const auto& [id, placed] : graph.submaps) {
    if (placed.submap->finished) snapshot.submaps.emplace(id, placed);
  }
  AddClosures(map_builder, &snapshot);
  return snapshot;
}

}  // namespace semantic_kiss::cli
