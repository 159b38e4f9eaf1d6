// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/filter.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/map/filter_scope.h"
#include "cartographer/map/label_choice.h"
#include "cartographer/map/remove_cells.h"
#include "cartographer/map/remove_points.h"
#include "cartographer/map/remove_transient.h"

namespace cartographer::map {
namespace {

sensor::LabelMask AllLabels() {
  sensor::LabelMask all;
  for (size_t i = 0; i < sensor::kMaxLabels; ++i) all.Insert(sensor::Label{uint8_t(i)});
  return all;
}

void RemoveLabels(const FilterScope& scope, const sensor::LabelMask& labels, Map* map) {
  const CellRule always = [](sensor::Label, const submap::CellIndex&, int) { return true; };
  RemoveCells(
      scope, labels, [&always](const submap::SubmapId&) { return always; }, map);
  RemoveLabeledPoints(scope, labels, map);
}

void RemoveRareCells(const FilterScope& scope, int min_hits, Map* map) {
  const CellRule is_rare = [min_hits](sensor::Label, const submap::CellIndex&, int hits) {
    return hits < min_hits;
  };
  const LostCells lost = RemoveCells(
      scope, AllLabels(), [&is_rare](const submap::SubmapId&) { return is_rare; }, map);
  RemovePointsOfLostCells(lost, map);
}

// Whether the options say what to remove, not only where.
bool HasRule(const proto::FilterOptions& options) {
  return !options.remove().empty() || !options.remove_roles().empty() || !options.keep().empty() ||
         !options.keep_roles().empty() || options.min_hits() > 1 || options.remove_transient();
}

absl::Status CheckTrajectories(const proto::FilterOptions& options, const FilterScope& scope) {
  const bool confined = !options.trajectories().empty() || !options.keep_trajectories().empty();
  if (!confined) {
    return absl::InvalidArgumentError(
        "nothing to remove: name labels or roles, a region, trajectories, min_hits or transient "
        "things");
  }
  if (!scope.all_trajectories) return absl::OkStatus();
  return absl::InvalidArgumentError(
      "trajectory: these are all of the map's, so that nothing would be left; keep at least one");
}

}  // namespace

absl::StatusOr<FilteredMap> Filter(Map map, const proto::FilterOptions& options) {
  ASSIGN_OR_RETURN(const sensor::LabelMask labels, LabelsToRemove(options, map.labels));
  ASSIGN_OR_RETURN(const FilterScope scope, FilterScope::Create(options, map));
  const LabelCounts before = CountMap(map);
  FilterReport report;
  if (HasRule(options)) {
    if (!labels.Empty()) RemoveLabels(scope, labels, &map);
    if (options.min_hits() > 1) RemoveRareCells(scope, options.min_hits(), &map);
    if (options.remove_transient()) RemoveTransient(scope, options.transient(), &map);
  } else if (!scope.region.IsEverywhere()) {
    RemoveLabels(scope, AllLabels(), &map);
  } else {
    RETURN_IF_ERROR(CheckTrajectories(options, scope));
    report.trajectories = RemoveTrajectories(scope.trajectories, &map);
  }
  report.labels = Difference(before, CountMap(map));
  if (!report.IsEmpty()) map.history.push_back(HistoryLine(options, report, map.labels));
  return FilteredMap{std::move(map), std::move(report)};
}

}  // namespace cartographer::map
