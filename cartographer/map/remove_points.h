// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_REMOVE_POINTS_H_
#define CARTOGRAPHER_MAP_REMOVE_POINTS_H_

#include "cartographer/map/filter_scope.h"
#include "cartographer/map/map.h"
#include "cartographer/map/remove_cells.h"
#include "cartographer/sensor/label.h"

namespace cartographer::map {

// Both remove points from the clouds of submaps and nodes, in parallel. Clouds that lose nothing
// stay the same objects.

// Points of `labels` in the scope that lie in its region.
void RemoveLabeledPoints(const FilterScope& scope, const sensor::LabelMask& labels, Map* map);

// The points that lie where cells lost the hits of their label. A submap's point goes with its
// cell; a node's point goes with the last of the cells that it hit, in whichever of the submaps
// that hold the node.
void RemovePointsOfLostCells(const LostCells& lost, Map* map);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_REMOVE_POINTS_H_
