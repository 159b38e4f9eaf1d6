// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/filter_scope.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/status.h"
#include "cartographer/map/trajectories.h"

namespace cartographer::map {
namespace {

using Ids = google::protobuf::RepeatedField<int32_t>;

absl::Status CheckKnown(const Ids& ids, const std::set<int>& known) {
  for (const int id : ids) {
    if (known.count(id) > 0) continue;
    return absl::NotFoundError(absl::StrCat("the map has no trajectory ", id, "; it has ",
                                            known.empty() ? "none" : absl::StrJoin(known, ", ")));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<FilterScope> FilterScope::Create(const proto::FilterOptions& options,
                                                const Map& map) {
  FilterScope scope;
  ASSIGN_OR_RETURN(scope.region, Region::Create(options));
  const std::set<int> known = TrajectoriesOf(map);
  const Ids &wanted = options.trajectories(), &kept = options.keep_trajectories();
  RETURN_IF_ERROR(common::AddContext(CheckKnown(wanted, known), "trajectory"));
  RETURN_IF_ERROR(common::AddContext(CheckKnown(kept, known), "keep_trajectory"));
  if (!wanted.empty() && !kept.empty()) {
    return absl::InvalidArgumentError(
        "keep_trajectory: trajectories to remove from are named as well; give one of the two");
  }
  scope.trajectories = wanted.empty() ? known : std::set<int>(wanted.begin(), wanted.end());
  for (const int id : kept) scope.trajectories.erase(id);
  scope.all_trajectories = scope.trajectories.size() == known.size();
  return scope;
}

}  // namespace cartographer::map
