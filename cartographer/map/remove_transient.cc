// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_transient.h"

#include "cartographer/map/remove_cells.h"
#include "cartographer/map/remove_points.h"
#include "cartographer/map/witnesses.h"

namespace cartographer::map {

void RemoveTransient(const FilterScope& scope, const proto::TransientOptions& options, Map* map) {
  sensor::LabelMask labels = map->labels.WithRole(sensor::LabelRole::kMovable);
  labels.Insert(sensor::kUnlabeled);
  Witnesses witnesses(options, labels, *map);
  LostCells lost;
  const LostCells* among = nullptr;  // in the first round all are heard, later those that changed
  do {
    lost = RemoveCells(
        scope, labels, [&](const submap::SubmapId& id) { return witnesses.RuleFor(id, among); },
        map);
    among = &lost;
    RemovePointsOfLostCells(lost, map);
    witnesses.Update(lost, *map);
  } while (!lost.empty());
}

}  // namespace cartographer::map
