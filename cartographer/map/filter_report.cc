// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/filter_report.h"

#include <algorithm>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"

namespace cartographer::map {
namespace {

std::string Number(double value) { return absl::StrFormat("%.10g", value); }

// " --name=a,b", nothing for an empty list.
template <typename List>
std::string ListFlag(const char* name, const List& list) {
  if (list.empty()) return "";
  return absl::StrCat(" --", name, "=", absl::StrJoin(list, ","));
}

std::string NumbersFlag(const char* name, const google::protobuf::RepeatedField<double>& numbers) {
  std::vector<std::string> texts;
  for (const double number : numbers) texts.push_back(Number(number));
  return ListFlag(name, texts);
}

std::string TransientText(const proto::TransientOptions& options) {
  return absl::StrCat(" --remove_transient (min_time_between_visits_s = ",
                      Number(options.min_time_between_visits_s()),
                      ", tolerance_m = ", Number(options.tolerance_m()),
                      ", min_ground_hits = ", options.min_ground_hits(),
                      ", max_movable_share = ", Number(options.max_movable_share()),
                      ", max_height_difference_m = ", Number(options.max_height_difference_m()),
                      ")");
}

std::string Flags(const proto::FilterOptions& options) {
  return absl::StrCat(
      ListFlag("remove", options.remove()), ListFlag("remove_role", options.remove_roles()),
      ListFlag("keep", options.keep()), ListFlag("keep_role", options.keep_roles()),
      NumbersFlag("polygon", options.polygon()), NumbersFlag("box", options.box()),
      options.outside() ? " --outside" : "", ListFlag("trajectory", options.trajectories()),
      ListFlag("keep_trajectory", options.keep_trajectories()),
      options.min_hits() > 1 ? absl::StrCat(" --min_hits=", options.min_hits()) : "",
      options.remove_transient() ? TransientText(options.transient()) : "");
}

std::string Removed(const ElementCount& elements) {
  return absl::StrCat(elements.nodes, " nodes, ", elements.submaps, " submaps, ",
                      elements.constraints, " constraints");
}

std::string Removed(const LabelCount& count, const std::string& name) {
  return absl::StrCat(count.hits, " hits, ", count.submap_points, " submap points, ",
                      count.node_points, " node points of ", name);
}

bool IsZero(const ElementCount& elements) {
  return elements.nodes == 0 && elements.submaps == 0 && elements.constraints == 0;
}

}  // namespace

bool FilterReport::IsEmpty() const {
  return IsZero(trajectories) && std::all_of(labels.begin(), labels.end(),
                                             [](const auto& count) { return count.IsZero(); });
}

std::string HistoryLine(const proto::FilterOptions& options, const FilterReport& report,
                        const sensor::LabelSet& labels) {
  std::vector<std::string> parts;
  if (!IsZero(report.trajectories)) parts.push_back(Removed(report.trajectories));
  for (size_t i = 0; i < report.labels.size(); ++i) {
    if (report.labels[i].IsZero()) continue;
    parts.push_back(Removed(report.labels[i], labels.Name(sensor::Label{static_cast<uint8_t>(i)})));
  }
  return absl::StrCat("filter", Flags(options), ": removed ", absl::StrJoin(parts, "; "));
}

}  // namespace cartographer::map
