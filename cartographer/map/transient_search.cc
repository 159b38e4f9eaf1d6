// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/transient_search.h"

#include <algorithm>
#include <cmath>

#include "cartographer/common/parallel.h"
#include "cartographer/common/time.h"
#include "cartographer/map/free_cells.h"

namespace cartographer::map {
namespace {

using submap::CellIndex;

constexpr int kTileSize = submap::SemanticGrid::kTileSize;
// Side of the places that are looked at one by one, in cells.
constexpr int kPlaceSide = 128;

}  // namespace

TransientSearch::TransientSearch(const proto::TransientOptions& options,
                                 const sensor::LabelMask& standing, const Map& map)
    : options_(options),
      standing_(standing),
      ground_(map.labels.WithRole(sensor::LabelRole::kGround)),
      viewers_(ViewersOf(map)),
      cell_m_(CellSide_m(viewers_)),
      reach_(static_cast<int>(std::lround(options.tolerance_m() / cell_m_))) {}

std::vector<CellSet> TransientSearch::Search(const Map& map) const {
  sensor::LabelMask labels = standing_;
  for (size_t i = 0; i < map.labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    if (ground_.Contains(label)) labels.Insert(label);
  }
  const std::vector<Place> places = PlacesOf(map, viewers_, labels, {kPlaceSide, reach_});
  const auto found = common::ParallelMapChunks<std::vector<ViewedCell>>(
      places.size(), 1, [&](size_t i, size_t) { return SearchPlace(places[i]); });
  std::vector<CellSet> cells(viewers_.size());
  for (const std::vector<ViewedCell>& of_place : found) {
    for (const ViewedCell& viewed : of_place) cells[viewed.viewer].Insert(viewed.cell);
  }
  return cells;
}

bool TransientSearch::BelongTogether(const Viewer& earlier, const Viewer& later) const {
  if (earlier.id.trajectory_id != later.id.trajectory_id) return false;
  if (!earlier.last_time.has_value() || !later.first_time.has_value()) return true;
  return *later.first_time - *earlier.last_time <
         common::FromSeconds(options_.min_time_between_visits_s());
}

bool TransientSearch::OnOtherLevel(const Viewer& viewer, const Visit& visit) const {
  return viewer.height_m > visit.highest_m + options_.max_height_difference_m() ||
         viewer.height_m < visit.lowest_m - options_.max_height_difference_m();
}

std::vector<TransientSearch::Visit> TransientSearch::VisitsOf(const Place& place) const {
  std::vector<Visit> visits;
  for (const Place::SeenTile& tile : place.tiles) {
    if (!visits.empty() && visits.back().viewers.back() == tile.viewer) continue;
    const Viewer& viewer = viewers_[tile.viewer];
    if (visits.empty() || !BelongTogether(viewers_[visits.back().viewers.back()], viewer)) {
      visits.push_back({{}, viewer.height_m, viewer.height_m, {}});
    }
    Visit& visit = visits.back();
    visit.viewers.push_back(tile.viewer);
    visit.lowest_m = std::min(visit.lowest_m, viewer.height_m);
    visit.highest_m = std::max(visit.highest_m, viewer.height_m);
  }
  return visits;
}

// Calls body(cell, hits, cell of the map in which its centre lies) for the cells with hits.
template <typename Body>
void TransientSearch::ForEachHit(const Place::SeenTile& seen, const Body& body) const {
  const Viewer& viewer = viewers_[seen.viewer];
  const CellIndex corner = CellIndex(seen.index.x, seen.index.y) * kTileSize;
  for (int i = 0; i < kTileSize * kTileSize; ++i) {
    if (seen.tile->hits[i] == 0) continue;
    const CellIndex cell = corner + CellIndex(i % kTileSize, i / kTileSize);
    const Eigen::Vector2d center = viewer.resolution_m * (cell.cast<double>() + 0.5).matrix();
    const Eigen::Array2d in_map = (viewer.map_from_grid * center).array() / cell_m_;
    body(cell, seen.tile->hits[i], CellIndex(in_map.floor().cast<int>()));
  }
}

void TransientSearch::FindFreeCells(const Place& place, std::vector<Visit>* visits) const {
  auto tile = place.tiles.begin();
  for (Visit& visit : *visits) {
    VisitedSquare square(place.min, kPlaceSide, reach_);
    for (; tile != place.tiles.end() && tile->viewer <= visit.viewers.back(); ++tile) {
      const bool stands = standing_.Contains(tile->label);
      ForEachHit(*tile, [&](const CellIndex&, int hits, const CellIndex& in_map) {
        stands ? square.AddStanding(in_map, hits) : square.AddGround(in_map, hits);
      });
    }
    visit.free = square.FreeCells(options_);
  }
}

std::vector<TransientSearch::ViewedCell> TransientSearch::SearchPlace(const Place& place) const {
  std::vector<Visit> visits = VisitsOf(place);
  if (visits.size() < 2) return {};
  FindFreeCells(place, &visits);
  std::vector<ViewedCell> found;
  auto own = visits.begin();
  for (const Place::SeenTile& tile : place.tiles) {
    while (own->viewers.back() < tile.viewer) ++own;
    if (!standing_.Contains(tile.label)) continue;
    std::vector<const Visit*> others;
    for (auto visit = visits.begin(); visit != visits.end(); ++visit) {
      if (visit != own && !OnOtherLevel(viewers_[tile.viewer], *visit)) others.push_back(&*visit);
    }
    ForEachHit(tile, [&](const CellIndex& cell, int, const CellIndex& in_map) {
      const CellIndex offset = in_map - place.min;
      if ((offset < 0).any() || (offset >= kPlaceSide).any()) return;
      const size_t index = size_t(offset.y()) * kPlaceSide + offset.x();
      if (std::any_of(others.begin(), others.end(),
                      [index](const Visit* visit) { return visit->free[index]; })) {
        found.push_back({tile.viewer, cell});
      }
    });
  }
  return found;
}

}  // namespace cartographer::map
