// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_MAP_H_
#define CARTOGRAPHER_MAP_MAP_H_

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cartographer/common/time.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/submap.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::map {

// A submap placed in the map.
struct MapSubmap {
  transform::Rigid3d map_from_submap;
  std::shared_ptr<const submap::Submap> submap;
};

// A scan placed in the map.
struct MapNode {
  common::Time time;
  transform::Rigid3d map_from_node;    // after optimization
  transform::Rigid3d local_from_node;  // as the odometry had it
  // Sub-sampled scan, in the node's (sensor's) frame. Never null; may be empty.
  std::shared_ptr<const sensor::LabeledPointCloud> cloud;
};

// What is known of a node relative to a submap.
struct Constraint {
  enum class Kind {
    kIntraSubmap,  // the node's scan is in the submap
    kInterSubmap   // found by loop closure
  };
  submap::SubmapId submap_id;
  submap::NodeId node_id;
  transform::Rigid3d submap_from_node;
  double translation_weight = 1.;
  double rotation_weight = 1.;
  Kind kind = Kind::kIntraSubmap;
};

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
