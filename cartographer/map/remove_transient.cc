// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_transient.h"

#include <map>
#include <vector>

#include "cartographer/map/cell_set.h"
#include "cartographer/map/remove_cells.h"
#include "cartographer/map/remove_points.h"
#include "cartographer/map/transient_search.h"

namespace cartographer::map {

void RemoveTransient(const FilterScope& scope, const proto::TransientOptions& options, Map* map) {
  if (map->submaps.empty()) return;
  sensor::LabelMask labels = map->labels.WithRole(sensor::LabelRole::kMovable);
  labels.Insert(sensor::kUnlabeled);
  const TransientSearch search(options, labels, *map);
  LostCells lost;
  do {
    const std::vector<CellSet> found = search.Search(*map);
    std::map<submap::SubmapId, const CellSet*> cells_of_submap;
    for (size_t i = 0; i < found.size(); ++i) {
      cells_of_submap[search.viewers()[i].id] = &found[i];
    }
    const auto rule_of = [&cells_of_submap](const submap::SubmapId& id) -> CellRule {
      const CellSet& cells = *cells_of_submap.at(id);
      if (cells.Empty()) return nullptr;
      return [&cells](sensor::Label, const submap::CellIndex& cell, int) {
        return cells.Contains(cell);
      };
    };
    lost = RemoveCells(scope, labels, rule_of, map);
    RemovePointsOfLostCells(lost, map);
  } while (!lost.empty());
}

}  // namespace cartographer::map
