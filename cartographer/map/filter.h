// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_FILTER_H_
#define CARTOGRAPHER_MAP_FILTER_H_

#include "absl/status/statusor.h"
#include "cartographer/map/filter_report.h"
#include "cartographer/map/map.h"
#include "cartographer/map/proto/filter_options.pb.h"

namespace cartographer::map {

struct FilteredMap {
  Map map;
  FilterReport report;
};

// Removes from submaps' grids, submaps' clouds and nodes' clouds alike what the options name
// (docs/maps.md), in this order:
//   1. labels       hits and points of the labels to remove;
//   2. min_hits     the cells of a submap's layer with fewer hits, and the points in them;
//   3. transient    what one visit saw and another did not (remove_transient.h).
// Each is confined to the region and the trajectories, if such are given. If there is nothing but
// these, all that lies there goes: whole trajectories with submaps, nodes and constraints, or all
// hits and points of a region. Otherwise submaps and nodes stay, be they empty.
//
// Cells are judged by their centres, points by their own place. What is not removed stays bit by
// bit. A map that lost something says so in its history, in one line; if nothing was removed the
// map is the same, which makes filtering twice the same as once.
//
// Errors begin with the option: names, roles, trajectories and shapes that cannot be
// (label_choice.h, filter_scope.h), options that remove nothing at all, trajectories without which
// the map would be empty.
absl::StatusOr<FilteredMap> Filter(Map map, const proto::FilterOptions& options);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_FILTER_H_
