// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_TRANSIENT_SEARCH_H_
#define CARTOGRAPHER_MAP_TRANSIENT_SEARCH_H_

#include <vector>

#include "cartographer/map/cell_set.h"
#include "cartographer/map/map.h"
#include "cartographer/map/places.h"
#include "cartographer/map/proto/filter_options.pb.h"
#include "cartographer/sensor/label.h"

namespace cartographer::map {

// Looks for what was there on one visit and gone on another, place by place. The submaps that saw a
// place are cut into visits where more time passes between two of them than the options allow, or
// another trajectory begins. A visit tells as a whole what it found free (free_cells.h): a submap
// of its own has often seen but one side of a thing, and the ground right behind the other.
class TransientSearch {
 public:
  // `standing`: labels of what may come and go.
  TransientSearch(const proto::TransientOptions& options, const sensor::LabelMask& standing,
                  const Map& map);

  // For each viewer the cells in which it has hits of `standing` and that another visit found
  // free. The map may have lost hits since the search was made, but has the same submaps.
  std::vector<CellSet> Search(const Map& map) const;

  const std::vector<Viewer>& viewers() const { return viewers_; }

 private:
  // The viewers of a place that came by at one time.
  struct Visit {
    std::vector<int> viewers;
    double lowest_m, highest_m;  // heights of their origins
    std::vector<bool> free;      // cells of the place, row by row
  };
  // A cell of a viewer's grid.
  struct ViewedCell {
    int viewer;
    submap::CellIndex cell;
  };

  bool BelongTogether(const Viewer& earlier, const Viewer& later) const;
  bool OnOtherLevel(const Viewer& viewer, const Visit& visit) const;
  std::vector<Visit> VisitsOf(const Place& place) const;
  void FindFreeCells(const Place& place, std::vector<Visit>* visits) const;
  std::vector<ViewedCell> SearchPlace(const Place& place) const;
  template <typename Body>
  void ForEachHit(const Place::SeenTile& seen, const Body& body) const;

  const proto::TransientOptions options_;
  const sensor::LabelMask standing_, ground_;
  const std::vector<Viewer> viewers_;
  const double cell_m_;  // side of the map's cells
  const int reach_;      // of the tolerance, in cells
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_TRANSIENT_SEARCH_H_
