// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/loaded_map.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/slam/graph_of_map.h"

namespace semantic_kiss::cli {

using cartographer::map::Map;
using cartographer::sensor::Label;
using cartographer::sensor::LabelSet;

namespace {

// Map files number trajectories up to 1e9. Two maps of this many can be joined and read again.
constexpr int kMaxTrajectories = 400'000'000;

bool SameLabels(const LabelSet& a, const LabelSet& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (a.Name(label) != b.Name(label)) return false;
  }
  return true;
}

}  // namespace

absl::StatusOr<Map> LoadMapFor(const LabelSet& labels, const std::string& path,
                               const cartographer::io::MapParts& parts) {
  ASSIGN_OR_RETURN(Map map, cartographer::io::ReadMapParts(path, parts));
  if (map.submaps.empty()) {
    return absl::FailedPreconditionError(absl::StrCat(path, ": the map has no submaps"));
  }
  if (cartographer::slam::NextTrajectoryId(map) > kMaxTrajectories) {
    return absl::FailedPreconditionError(
        absl::StrCat(path, ": its trajectories are numbered beyond ", kMaxTrajectories - 1,
                     ", so that nothing can be joined to them; is the file damaged?"));
  }
  if (map.labels.size() > 1 && !SameLabels(map.labels, labels)) {
    return absl::FailedPreconditionError(
        absl::StrCat(path, ": its labels are those of \"", map.labels.name(),
                     "\", the configuration's those of \"", labels.name(),
                     "\"; choose a configuration with the map's label_set"));
  }
  return map;
}

}  // namespace semantic_kiss::cli
