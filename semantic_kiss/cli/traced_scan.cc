// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/traced_scan.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/status.h"
#include "semantic_kiss/cli/flag_list.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::pose_graph::Closure;
using cartographer::pose_graph::NodeSearch;
using cartographer::slam::LocalResult;
using cartographer::slam::MapBuilder;
using cartographer::slam::ScanPose;
using cartographer::slam::TraceStep;
using cartographer::submap::NodeId;

std::string MatchText(const Closure& closure) {
  return absl::StrFormat("submap %d (%s), score %.2f, overlap %.2f, inliers %.2f",
                         closure.constraint.submap_id.submap_index,
                         closure.by_place_recognition ? "place recognition" : "nearby",
                         closure.score, closure.overlap, closure.inlier_ratio);
}

std::string ClosuresText(const MapBuilder& map_builder, const NodeId& node_id) {
  const auto found = map_builder.closure_searches().find(node_id);
  if (found == map_builder.closure_searches().end()) {
    return "not looked for: only some nodes are, a certain way apart";
  }
  const NodeSearch& search = found->second;
  if (search.num_candidates == 0) return "no candidates: nothing to close with is near or alike";
  std::string text =
      absl::StrCat(search.num_accepted, " of ", search.num_candidates, " candidates accepted");
  const Closure* best = nullptr;
  for (const Closure& closure : map_builder.closures()) {
    if (!(closure.constraint.node_id == node_id)) continue;
    if (best == nullptr || closure.score > best->score) best = &closure;
  }
  if (best != nullptr) absl::StrAppend(&text, "; best: ", MatchText(*best));
  if (search.best_rejected.has_value()) {
    absl::StrAppend(&text, "; best of the others: ", search.best_rejected->verdict, ", ",
                    MatchText(search.best_rejected->closure));
  }
  return text;
}

}  // namespace

absl::StatusOr<std::set<int>> ScansToTrace(absl::string_view list) {
  const absl::StatusOr<std::vector<int>> numbers = IntegersOf(list);
  RETURN_IF_ERROR(cartographer::common::AddContext(numbers.status(), "--trace_scan"));
  return std::set<int>(numbers->begin(), numbers->end());
}

absl::Status CheckScansToTrace(const std::set<int>& numbers, int first, int count) {
  for (const int number : numbers) {
    if (number >= first && number - first < count) continue;
    return absl::OutOfRangeError(absl::StrCat("--trace_scan: scan ", number,
                                              " is not driven through; name one from ", first,
                                              " to ", first + count - 1));
  }
  return absl::OkStatus();
}

LocalResult AddTraced(const cartographer::sensor::LabeledScan& scan, double reading_s,
                      MapBuilder* map_builder, TracedScan* traced) {
  traced->number = scan.index;
  traced->position = static_cast<int>(map_builder->scan_poses().size());
  TraceStep reading{cartographer::slam::kReadingStep, "sensor", "as the files have it"};
  traced->steps.push_back(reading.Gives(scan.points).Took(reading_s));
  map_builder->TraceTo(&traced->steps);
  LocalResult result = map_builder->AddScan(scan);
  map_builder->TraceTo(nullptr);
  traced->is_node = result.insertion.has_value();
  return result;
}

void CompleteTrace(const MapBuilder& map_builder, const cartographer::map::Map& map,
                   TracedScan* traced) {
  const ScanPose& scan = map_builder.scan_poses()[traced->position];
  if (traced->is_node) {
    traced->steps.push_back({"closures", "map", ClosuresText(map_builder, scan.node_id)});
  }
  traced->steps.push_back(
      {"place", "map",
       absl::StrCat("in the end ",
                    cartographer::slam::PoseText(map.nodes.at(scan.node_id).map_from_node *
                                                 scan.node_from_sensor))});
}

}  // namespace semantic_kiss::cli
