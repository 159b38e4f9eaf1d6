// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/options_loader.h"
#include "cartographer/common/status.h"
#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/map/filter.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/distinct_files.h"
#include "semantic_kiss/cli/flag_list.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

namespace map = cartographer::map;
using cartographer::common::AddContext;
using cartographer::sensor::Label;
using map::proto::FilterOptions;

// Replaces an option that is a list by a flag that is given.
template <typename Value, typename List>
absl::Status ApplyList(const char* flag, const absl::StatusOr<std::vector<Value>>& values,
                       List* list) {
  if (!IsGiven(flag)) return absl::OkStatus();
  if (!values.ok()) return AddContext(values.status(), flag);
  list->Clear();
  for (const Value& value : *values) *list->Add() = value;
  return absl::OkStatus();
}

absl::Status ApplyFlags(FilterOptions* options) {
  using Words = absl::StatusOr<std::vector<std::string>>;
  const auto apply_words = [](const char* flag, const std::string& value, auto* list) {
    return ApplyList(flag, Words(WordsOf(value)), list);
  };
  RETURN_IF_ERROR(apply_words("remove", FLAGS_remove, options->mutable_remove()));
  RETURN_IF_ERROR(apply_words("remove_role", FLAGS_remove_role, options->mutable_remove_roles()));
  RETURN_IF_ERROR(apply_words("keep", FLAGS_keep, options->mutable_keep()));
  RETURN_IF_ERROR(apply_words("keep_role", FLAGS_keep_role, options->mutable_keep_roles()));
  RETURN_IF_ERROR(ApplyList("polygon", NumbersOf(FLAGS_polygon), options->mutable_polygon()));
  RETURN_IF_ERROR(ApplyList("box", NumbersOf(FLAGS_box), options->mutable_box()));
  RETURN_IF_ERROR(
      ApplyList("trajectory", IntegersOf(FLAGS_trajectory), options->mutable_trajectories()));
  RETURN_IF_ERROR(ApplyList("keep_trajectory", IntegersOf(FLAGS_keep_trajectory),
                            options->mutable_keep_trajectories()));
  if (IsGiven("outside")) options->set_outside(FLAGS_outside);
  if (IsGiven("min_hits")) options->set_min_hits(FLAGS_min_hits);
  if (IsGiven("remove_transient")) options->set_remove_transient(FLAGS_remove_transient);
  return absl::OkStatus();
}

absl::StatusOr<FilterOptions> LoadFilterOptions() {
  const std::string installed = InstalledConfigurationDirectory();
  ASSIGN_OR_RETURN(const std::string path,
                   cartographer::common::FindLuaFile(
                       IsGiven("config") ? FLAGS_config : "filter.lua", {"", installed}));
  FilterOptions options;
  RETURN_IF_ERROR(cartographer::common::LoadOptions({path, {installed}}, &options));
  RETURN_IF_ERROR(ApplyFlags(&options));
  return options;
}

void PrintReport(const map::FilterReport& report, const cartographer::sensor::LabelSet& labels) {
  if (report.IsEmpty()) {
    std::cout << "nothing was removed\n";
    return;
  }
  const map::ElementCount& gone = report.trajectories;
  if (gone.nodes + gone.submaps + gone.constraints > 0) {
    std::cout << absl::StreamFormat("removed %d nodes, %d submaps, %d constraints\n", gone.nodes,
                                    gone.submaps, gone.constraints);
  }
  std::cout << absl::StreamFormat("%-20s %12s %14s %12s\n", "removed", "grid hits", "submap points",
                                  "node points");
  for (size_t i = 0; i < report.labels.size(); ++i) {
    const map::LabelCount& count = report.labels[i];
    if (count.IsZero()) continue;
    std::cout << absl::StreamFormat("%-20s %12d %14d %12d\n",
                                    labels.Name(Label{static_cast<uint8_t>(i)}), count.hits,
                                    count.submap_points, count.node_points);
  }
}

absl::Status RunFilter() {
  ASSIGN_OR_RETURN(const FilterOptions options, LoadFilterOptions());
  RETURN_IF_ERROR(CheckOutputIsNotMap(FLAGS_map, FLAGS_output));
  ASSIGN_OR_RETURN(map::Map map, cartographer::io::ReadMap(FLAGS_map));
  ASSIGN_OR_RETURN(const map::FilteredMap filtered, map::Filter(std::move(map), options));
  RETURN_IF_ERROR(cartographer::io::WriteMap(filtered.map, FLAGS_output));
  if (!FLAGS_quiet) PrintReport(filtered.report, filtered.map.labels);
  return absl::OkStatus();
}

}  // namespace

Command FilterCommand() {
  Command command;
  command.name = "filter";
  command.summary = "remove classes, places, drives or passers-by from a map";
  command.description =
      "Writes a copy of a map without what the flags name: whole classes, cells that were hardly "
      "seen, things that were there on one visit and gone on another. A region or a trajectory "
      "confines the removal; alone, all that it holds is removed. Grids, the clouds of submaps "
      "and the clouds of nodes are treated alike, what lies beneath the removed shows, and the "
      "copy's history tells what is missing. docs/maps.md has the details.\n\n"
      "Coordinates are those of the map in metres: x forward at its start, y left.";
  command.flags = {{"map", true}, {"config", false, "filter.lua"},
                   {"remove"},    {"remove_role"},
                   {"keep"},      {"keep_role"},
                   {"polygon"},   {"box"},
                   {"outside"},   {"trajectory"},
                   {"min_hits"},  {"keep_trajectory"},
                   {"quiet"},     {"remove_transient"},
                   {"threads"},   {"output", true}};
  command.examples = {
      {"A map of what will still be there tomorrow",
       "filter --map=map.pbstream --output=lasting.pbstream --remove_role=movable"},
      {"Without the cars of one parking lot",
       "filter --map=map.pbstream --output=out.pbstream --remove=car --box=20,-15,60,10"},
      {"Only what lies within a polygon",
       "filter --map=map.pbstream --output=out.pbstream --outside --polygon=0,0,90,0,40,70"},
      {"Without what only one of several visits saw, and without specks",
       "filter --map=map.pbstream --output=out.pbstream --remove_transient --min_hits=3"}};
  command.run = &RunFilter;
  return command;
}

}  // namespace semantic_kiss::cli
