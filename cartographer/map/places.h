// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_PLACES_H_
#define CARTOGRAPHER_MAP_PLACES_H_

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "cartographer/common/time.h"
#include "cartographer/map/map.h"
#include "cartographer/sensor/label.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::map {

// A submap as one that saw places.
struct Viewer {
  submap::SubmapId id;
  // Of the nodes that it holds; nullopt if there are none.
  std::optional<common::Time> first_time, last_time;
  double height_m = 0.;  // of its origin in the map
  double resolution_m = 0.;
  Eigen::Isometry2d map_from_grid;
};

// All submaps, by id.
std::vector<Viewer> ViewersOf(const Map& map);

// A square of the map, seen from above, with the tiles that submaps have there.
struct Place {
  struct SeenTile {
    int viewer;  // index
    sensor::Label label;
    submap::SemanticGrid::TileIndex index;
    const submap::SemanticGrid::Tile* tile;
  };
  // In cells of the map frame: [min, min + side) along both axes.
  submap::CellIndex min;
  std::vector<SeenTile> tiles;  // by viewer
};

// Cells of the map frame are squares of this side, the coarsest grid's; 0 without grids.
double CellSide_m(const std::vector<Viewer>& viewers);

// In cells of the map frame.
struct PlaceSize {
  int side = 0;    // of a place
  int margin = 0;  // tiles that come this near to a place are listed there, too
};

// Cuts the map into squares and lists the tiles of `labels` in each. Squares without a tile are
// left out, and tiles over 1e8 cells from the map's origin. The tiles belong to the map.
std::vector<Place> PlacesOf(const Map& map, const std::vector<Viewer>& viewers,
                            const sensor::LabelMask& labels, const PlaceSize& size);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_PLACES_H_
