// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_WITNESSES_H_
#define CARTOGRAPHER_MAP_WITNESSES_H_

#include <Eigen/Geometry>
#include <map>
#include <optional>

#include "cartographer/common/time.h"
#include "cartographer/map/free_cells.h"
#include "cartographer/map/map.h"
#include "cartographer/map/proto/filter_options.pb.h"
#include "cartographer/map/remove_cells.h"
#include "cartographer/sensor/label.h"
#include "cartographer/submap/id.h"

namespace cartographer::map {

// The submaps of a map as witnesses against each other: what one saw standing, did one of another
// visit find the bare ground there? TransientOptions says which submaps are of different visits and
// may judge each other.
class Witnesses {
 public:
  // `standing`: the labels of what may come and go.
  Witnesses(const proto::TransientOptions& options, const sensor::LabelMask& standing,
            const Map& map);

  // Looks once more at submaps that lost something.
  void Update(const LostCells& lost, const Map& map);

  // The rule that takes from a submap the cells that others found free (free_cells.h); empty if
  // there is nobody to tell. `among`: the submaps whose word counts; nullptr: all. The rule is
  // valid as long as the witnesses are and do not change.
  CellRule RuleFor(const submap::SubmapId& id, const LostCells* among) const;

 private:
  struct TimeSpan {
    common::Time first, last;
  };
  struct Witness {
    submap::SubmapId id;
    std::optional<TimeSpan> times;  // of the nodes that the submap holds
    double height_m = 0.;           // of its origin
    Eigen::Isometry2d map_from_grid, grid_from_map;
    Eigen::AlignedBox2d bounds_m;  // of its hits, in the map frame
    double resolution_m = 0.;
    FreeCells free;

    bool FoundFree(const Eigen::Vector2d& position_m) const;
  };

  static std::map<submap::SubmapId, TimeSpan> TimesOfSubmaps(const Map& map);
  Witness MakeWitness(const submap::SubmapId& id, const MapSubmap& placed,
                      const std::map<submap::SubmapId, TimeSpan>& times) const;
  FreeCells FreeCellsOf(const submap::Submap& submap) const;
  bool AreDifferentVisits(const Witness& a, const Witness& b) const;
  bool CanTell(const Witness& witness, const Witness& about) const;

  const proto::TransientOptions options_;
  const sensor::LabelMask ground_, standing_;
  std::map<submap::SubmapId, Witness> witnesses_;
};

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_WITNESSES_H_
