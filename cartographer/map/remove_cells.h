// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_REMOVE_CELLS_H_
#define CARTOGRAPHER_MAP_REMOVE_CELLS_H_

#include <Eigen/Geometry>
#include <functional>
#include <map>

#include "cartographer/map/filter_scope.h"
#include "cartographer/map/map.h"
#include "cartographer/sensor/label.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::map {

// Whether a label's hits (> 0) go from a cell of a submap. Empty: none go.
using CellRule = std::function<bool(sensor::Label label, const submap::CellIndex& cell, int hits)>;

// Hits that were removed, by submap; none is empty.
using LostCells = std::map<submap::SubmapId, submap::SemanticGrid>;

// Removes hits of `labels` from the cells of all submaps in the scope whose centres lie in its
// region, where the submap's rule says so. Layers of which nothing goes stay as they are; a submap
// that loses nothing stays the same object. Submaps are worked on in parallel, so rules must not
// change what they share.
LostCells RemoveCells(const FilterScope& scope, const sensor::LabelMask& labels,
                      const std::function<CellRule(const submap::SubmapId&)>& rule_of, Map* map);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_REMOVE_CELLS_H_
