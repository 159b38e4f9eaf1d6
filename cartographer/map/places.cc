// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/places.h"

#include <algorithm>
#include <map>
#include <utility>

#include "cartographer/map/remove_cells.h"

namespace cartographer::map {
namespace {

using submap::CellIndex;
using submap::SemanticGrid;
using submap::SubmapId;

struct TimeSpan {
  common::Time first, last;
};

std::map<SubmapId, TimeSpan> TimesOfSubmaps(const Map& map) {
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

// Squares by their place in the row and column of squares.
using SquareIndex = std::pair<int, int>;

struct SquareRange {
  CellIndex first, last;
};

// The squares that a tile comes near to; nullopt if it is too far away.
std::optional<SquareRange> SquaresOf(const Viewer& viewer, const SemanticGrid::TileIndex& index,
                                     const PlaceSize& size, double cell_m) {
  const double tile_m = SemanticGrid::kTileSize * viewer.resolution_m;
  Eigen::AlignedBox2d bounds;
  for (const int x : {index.x, index.x + 1}) {
    for (const int y : {index.y, index.y + 1}) {
      bounds.extend(viewer.map_from_grid * (tile_m * Eigen::Vector2d(x, y)));
    }
  }
  constexpr double kMaxCells = 1e8;
  const double farthest_m =
      std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
  if (!(farthest_m <= kMaxCells * cell_m)) return std::nullopt;
  // A cell more, as hits are put into the cell of the map in which their own cell's centre lies.
  const double margin_m = (size.margin + 1) * cell_m;
  const auto square_of = [&](const Eigen::Array2d& position_m) -> CellIndex {
    return (position_m / (size.side * cell_m)).floor().cast<int>();
  };
  return SquareRange{square_of(bounds.min().array() - margin_m),
                     square_of(bounds.max().array() + margin_m)};
}

}  // namespace

std::vector<Viewer> ViewersOf(const Map& map) {
  const std::map<SubmapId, TimeSpan> times = TimesOfSubmaps(map);
  std::vector<Viewer> viewers;
  for (const auto& [id, placed] : map.submaps) {
    Viewer viewer;
    viewer.id = id;
    if (const auto span = times.find(id); span != times.end()) {
      viewer.first_time = span->second.first;
      viewer.last_time = span->second.last;
    }
    viewer.height_m = placed.map_from_submap.translation().z();
    viewer.resolution_m = placed.submap->grid.resolution_m();
    viewer.map_from_grid = submap::MapFromGrid(placed);
    viewers.push_back(viewer);
  }
  return viewers;
}

double CellSide_m(const std::vector<Viewer>& viewers) {
  double coarsest_m = 0.;
  for (const Viewer& viewer : viewers) coarsest_m = std::max(coarsest_m, viewer.resolution_m);
  return coarsest_m;
}

std::vector<Place> PlacesOf(const Map& map, const std::vector<Viewer>& viewers,
                            const sensor::LabelMask& labels, const PlaceSize& size) {
  const double cell_m = CellSide_m(viewers);
  std::map<SquareIndex, Place> places;
  for (size_t i = 0; i < viewers.size(); ++i) {
    const SemanticGrid& grid = map.submaps.at(viewers[i].id).submap->grid;
    for (const sensor::Label label : grid.Labels()) {
      if (!labels.Contains(label)) continue;
      for (const auto& [index, tile] : grid.LayerOf(label)) {
        const std::optional<SquareRange> range = SquaresOf(viewers[i], index, size, cell_m);
        if (!range.has_value()) continue;
        for (int y = range->first.y(); y <= range->last.y(); ++y) {
          for (int x = range->first.x(); x <= range->last.x(); ++x) {
            Place& place = places[{y, x}];
            place.min = CellIndex(x, y) * size.side;
            place.tiles.push_back({static_cast<int>(i), label, index, tile});
          }
        }
      }
    }
  }
  std::vector<Place> result;
  result.reserve(places.size());
  for (auto& [index, place] : places) result.push_back(std::move(place));
  return result;
}

}  // namespace cartographer::map
