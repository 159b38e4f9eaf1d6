// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/trace_insertion.h"

#include "absl/strings/str_cat.h"

namespace cartographer::slam {

void TraceInsertion(const LocalResult& result, const InsertedPoints& points, double seconds,
                    ScanTrace* trace) {
  if (!result.insertion.has_value()) {
    TraceStep none{"node", "sensor",
                   points.placed ? "none: too near the last node in place and time"
                                 : "none: its place is not known"};
    trace->push_back(none.Took(seconds));
    return;
  }
  const sensor::LabeledPointCloud hits = sensor::WithoutLabels(points.into_submaps, points.moving);
  bool first = true;
  for (const auto& [index, submap] : result.insertion->submaps) {
    TraceStep step{absl::StrCat("submap ", index), "submap",
                   absl::StrCat("hits of its scan ", submap->num_scans,
                                submap->finished ? ", the last one" : "")};
    step.Takes(points.submaps_from, points.into_submaps.size()).Gives(hits);
    if (first) step.Took(seconds);
    first = false;
    trace->push_back(step);
  }
  TraceStep node{"node", "sensor", "a node, with this cloud"};
  trace->push_back(
      node.Takes(points.node_from, points.into_node.size()).Gives(*result.insertion->cloud));
}

}  // namespace cartographer::slam
