// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/witnesses.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cartographer/common/parallel.h"

namespace cartographer::map {
namespace {

using submap::CellIndex;
using submap::SemanticGrid;
using submap::SubmapId;

Eigen::AlignedBox2d BoundsOf(const SemanticGrid& grid, const Eigen::Isometry2d& map_from_grid) {
  Eigen::AlignedBox2d bounds;
  const SemanticGrid::CellBox box = grid.Bounds();
  if (box.Empty()) return bounds;
  for (const int x : {box.min.x(), box.max.x()}) {
    for (const int y : {box.min.y(), box.max.y()}) {
      bounds.extend(map_from_grid * (grid.resolution_m() * Eigen::Vector2d(x, y)));
    }
  }
  return bounds;
}

}  // namespace

bool Witnesses::Witness::FoundFree(const Eigen::Vector2d& position_m) const {
  if (!bounds_m.contains(position_m)) return false;
  const Eigen::Array2d cell = (grid_from_map * position_m).array() / resolution_m;
  return free.Contains(cell.floor().cast<int>());
}

Witnesses::Witnesses(const proto::TransientOptions& options, const sensor::LabelMask& standing,
                     const Map& map)
    : options_(options),
      ground_(map.labels.WithRole(sensor::LabelRole::kGround)),
      standing_(standing) {
  const std::map<SubmapId, TimeSpan> times = TimesOfSubmaps(map);
  std::vector<std::pair<SubmapId, const MapSubmap*>> submaps;
  for (const auto& [id, placed] : map.submaps) submaps.emplace_back(id, &placed);
  auto witnesses = common::ParallelMapChunks<std::optional<Witness>>(
      submaps.size(), 1,
      [&](size_t i, size_t) { return MakeWitness(submaps[i].first, *submaps[i].second, times); });
  for (std::optional<Witness>& witness : witnesses) {
    witnesses_.emplace(witness->id, *std::move(witness));
  }
}

std::map<SubmapId, Witnesses::TimeSpan> Witnesses::TimesOfSubmaps(const Map& map) {
  std::map<SubmapId, TimeSpan> times;
  for (const Constraint& constraint : map.constraints) {
    const auto node = map.nodes.find(constraint.node_id);
    if (constraint.kind != Constraint::Kind::kIntraSubmap || node == map.nodes.end()) continue;
    const common::Time time = node->second.time;
    TimeSpan& span = times.emplace(constraint.submap_id, TimeSpan{time, time}).first->second;
    span = {std::min(span.first, time), std::max(span.last, time)};
  }
  return times;
}

Witnesses::Witness Witnesses::MakeWitness(const SubmapId& id, const MapSubmap& placed,
                                          const std::map<SubmapId, TimeSpan>& times) const {
  const SemanticGrid& grid = placed.submap->grid;
  const Eigen::Isometry2d map_from_grid = MapFromGrid(placed);
  const auto span = times.find(id);
  return {id,
          span == times.end() ? std::nullopt : std::optional<TimeSpan>(span->second),
          placed.map_from_submap.translation().z(),
          map_from_grid,
          map_from_grid.inverse(),
          BoundsOf(grid, map_from_grid),
          grid.resolution_m(),
          FreeCellsOf(*placed.submap)};
}

FreeCells Witnesses::FreeCellsOf(const submap::Submap& submap) const {
  return FreeCells(submap.grid, ground_, standing_, options_);
}

void Witnesses::Update(const LostCells& lost, const Map& map) {
  std::vector<Witness*> changed;
  for (const auto& [id, grid] : lost) changed.push_back(&witnesses_.at(id));
  common::ParallelChunks(changed.size(), 1, [&](size_t i, size_t) {
    changed[i]->free = FreeCellsOf(*map.submaps.at(changed[i]->id).submap);
  });
}

bool Witnesses::AreDifferentVisits(const Witness& a, const Witness& b) const {
  if (a.id.trajectory_id != b.id.trajectory_id) return true;
  if (!a.times.has_value() || !b.times.has_value()) return false;
  const common::Duration min_time = common::FromSeconds(options_.min_time_between_visits_s());
  return a.times->last + min_time <= b.times->first || b.times->last + min_time <= a.times->first;
}

bool Witnesses::CanTell(const Witness& witness, const Witness& about) const {
  return AreDifferentVisits(witness, about) && witness.bounds_m.intersects(about.bounds_m) &&
         std::abs(witness.height_m - about.height_m) <= options_.max_height_difference_m();
}

CellRule Witnesses::RuleFor(const SubmapId& id, const LostCells* among) const {
  const Witness& self = witnesses_.at(id);
  std::vector<const Witness*> others;
  for (const auto& [other_id, other] : witnesses_) {
    if (among != nullptr && among->count(other_id) == 0) continue;
    if (CanTell(other, self)) others.push_back(&other);
  }
  if (others.empty()) return nullptr;
  return [&self, others](sensor::Label, const CellIndex& cell, int) {
    const Eigen::Vector2d center =
        self.map_from_grid * ((cell.cast<double>() + 0.5).matrix() * self.resolution_m);
    return std::any_of(others.begin(), others.end(),
                       [&center](const Witness* other) { return other->FoundFree(center); });
  };
}

}  // namespace cartographer::map
