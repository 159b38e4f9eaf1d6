// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_MAP_H_
#define CARTOGRAPHER_MAP_MAP_H_

#include <map>
#include <string>
#include <vector>

#include "cartographer/sensor/label_set.h"
#include "cartographer/submap/constraint.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/placed.h"

namespace cartographer::map {

using Constraint = submap::Constraint;
using MapNode = submap::PlacedNode;
using MapSubmap = submap::PlacedSubmap;

// The finished product as a plain value: everything that files carry and tools work on. Tools are
// functions from Map to Map or to a file; none needs a pose graph.
struct Map {
  std::map<submap::SubmapId, MapSubmap> submaps;
  std::map<submap::NodeId, MapNode> nodes;
  std::vector<Constraint> constraints;
  sensor::LabelSet labels;
  // The resolved configuration that made the map, as Lua; empty for maps of other systems.
  std::string configuration_lua;
  // Program and version that made the map, then one line for each tool that changed it since.
  std::vector<std::string> history;
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_MAP_H_
