// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/status.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/io/map_reader.h"
#include "cartographer/pose_graph/pose_graph.h"
#include "cartographer/slam/relocalizer.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/drive_flags.h"
#include "semantic_kiss/cli/file_hash.h"
#include "semantic_kiss/cli/flag_list.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/loaded_map.h"
#include "semantic_kiss/cli/localization.h"
#include "semantic_kiss/cli/localization_files.h"
#include "semantic_kiss/cli/output_directory.h"
#include "semantic_kiss/cli/peak_memory.h"
#include "semantic_kiss/cli/stop_signals.h"
#include "semantic_kiss/cli/summary_line.h"
#include "semantic_kiss/cli/terminal.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::map::Map;
using cartographer::slam::LocalizedScan;
using cartographer::slam::Relocalizer;

struct InitialPose {
  Eigen::Vector2d position;
  double yaw;
};

// Beyond these, cells and angles no longer tell one place from the next.
constexpr double kFarthest_m = 1e7;
constexpr double kLargestHeading_deg = 360.;

absl::StatusOr<std::optional<InitialPose>> ParseInitialPose() {
  if (!IsGiven("initial_pose")) return std::optional<InitialPose>();
  const absl::StatusOr<std::vector<double>> numbers = NumbersOf(FLAGS_initial_pose);
  RETURN_IF_ERROR(cartographer::common::AddContext(numbers.status(), "--initial_pose"));
  if (numbers->size() != 3) {
    return absl::InvalidArgumentError(
        absl::StrCat("--initial_pose=", FLAGS_initial_pose, " has ", numbers->size(),
                     " numbers in place of three: x, y in metres, heading in degrees"));
  }
  const Eigen::Vector2d position((*numbers)[0], (*numbers)[1]);
  const double heading_deg = (*numbers)[2];
  if (position.cwiseAbs().maxCoeff() > kFarthest_m || std::abs(heading_deg) > kLargestHeading_deg) {
    return absl::InvalidArgumentError(absl::StrCat(
        "--initial_pose=", FLAGS_initial_pose, " is out of range; x and y must be within ",
        kFarthest_m, " m, the heading within ", kLargestHeading_deg, " degrees"));
  }
  return InitialPose{position, heading_deg * M_PI / 180.};
}

absl::StatusOr<std::unique_ptr<Relocalizer>> MakeRelocalizer(const Configuration& configuration,
                                                             const Map& map) {
  if (configuration.options.pose_graph().optimize_every_n_nodes() == 0) {
    return absl::InvalidArgumentError(
        absl::StrCat(FLAGS_config,
                     ": pose_graph.optimize_every_n_nodes = 0 searches for nothing; set it to 1, "
                     "as relocalize.lua does"));
  }
  ASSIGN_OR_RETURN(auto pose_graph, cartographer::pose_graph::PoseGraph::Create(
                                        configuration.options.pose_graph(), configuration.labels));
  // So that it cannot fail later.
  RETURN_IF_ERROR(MakeLocalTrajectoryBuilder(configuration).status());
  return std::make_unique<Relocalizer>(
      configuration.options.relocalization(),
      [&configuration] { return *MakeLocalTrajectoryBuilder(configuration); },
      std::move(pose_graph), map);
}

std::string States(const Localization& localization) {
  std::map<std::string, int> counts;
  for (const LocalizedScan& scan : localization.scans) ++counts[std::string(StateName(scan.state))];
  return absl::StrJoin(counts, ", ", [](std::string* out, const auto& count) {
    absl::StrAppend(out, count.second, " scans ", count.first);
  });
}

std::string FirstFix(const Localization& localization) {
  const std::optional<int> first = localization.FirstFix();
  if (!first.has_value()) {
    const std::string& reason = localization.scans.back().reason;
    return absl::StrCat("never: nothing of the map was recognized along the drive",
                        reason.empty() ? "" : absl::StrCat(" (", reason, ")"));
  }
  return absl::StrCat("after ", *first, " scans");
}

void PrintSummary(const Localization& localization, const LocalizationContext& context) {
  const Terminal terminal = Terminal::Of(STDOUT_FILENO);
  const bool localized = localization.FirstFix().has_value();
  std::cout << SummaryLine(terminal, localized ? Style::kGreen : Style::kYellow, "fix",
                           FirstFix(localization))
            << SummaryLine(terminal, Style::kBold, "states", States(localization))
            << SummaryLine(terminal, Style::kBold, "speed",
                           absl::StrFormat(
                               "%.1f scans a second, map loaded in %.1f s, peak memory %.0f MiB",
                               localization.scans.size() / localization.elapsed_s,
                               context.map_loading_s, PeakMemory_mib()));
  const evaluation::LocalizationMetrics metrics = evaluation::Summarize(localization.errors);
  if (metrics.position_median_m.has_value()) {
    std::cout << SummaryLine(
        terminal, Style::kBold, "accuracy",
        absl::StrFormat("position %.3f m median, %.3f m at 95 %%; heading %.3f deg median; %d "
                        "scans in a wrong place",
                        *metrics.position_median_m, *metrics.position_p95_m,
                        *metrics.heading_median_deg, metrics.wrong_places));
  }
  std::cout << SummaryLine(terminal, Style::kBold, "map",
                           context.map_sha256_before == context.map_sha256_after
                               ? "unchanged"
                               : "CHANGED by somebody while this ran");
}

// Before hours of work rather than after them. None without --map_ground_truth.
absl::StatusOr<std::vector<evaluation::MappedPlace>> TruePlaces(const dataset::ScanSource& scans,
                                                                const Map& map) {
  if (FLAGS_map_ground_truth.empty()) return std::vector<evaluation::MappedPlace>();
  if (!scans.ground_truth().has_value()) {
    return absl::FailedPreconditionError(
        "--map_ground_truth needs the true poses of the drive, too: poses.txt beside its scans, or "
        "--ground_truth=FILE");
  }
  return ReadMappedPlaces(map, FLAGS_map_ground_truth);
}

void Compare(const dataset::ScanSource& scans, const std::vector<evaluation::MappedPlace>& places,
             Localization* localization) {
  if (places.empty()) return;
  const auto& truth = *scans.ground_truth();
  localization->errors = evaluation::LocalizationErrors(
      places, {truth.begin(), truth.begin() + localization->scans.size()},
      localization->CausalPoses());
}

absl::Status RunRelocalize() {
  ASSIGN_OR_RETURN(const Configuration configuration,
                   LoadConfiguration(IsGiven("config") ? FLAGS_config : "relocalize.lua"));
  ASSIGN_OR_RETURN(const std::optional<InitialPose> initial_pose, ParseInitialPose());
  ASSIGN_OR_RETURN(const auto scans, OpenScans(configuration));
  LocalizationContext context;
  ASSIGN_OR_RETURN(context.map_sha256_before, Sha256OfFile(FLAGS_map));
  cartographer::common::Stopwatch loading;
  cartographer::io::MapParts parts;
  parts.node_clouds = false;
  ASSIGN_OR_RETURN(const Map map, LoadMapFor(configuration.labels, FLAGS_map, parts));
  ASSIGN_OR_RETURN(const auto relocalizer, MakeRelocalizer(configuration, map));
  context.map_loading_s = loading.Lap();
  ASSIGN_OR_RETURN(const auto places, TruePlaces(*scans, map));
  if (initial_pose.has_value()) relocalizer->StartNear(initial_pose->position, initial_pose->yaw);
  ASSIGN_OR_RETURN(const OutputDirectory directory, OutputDirectory::Create(FLAGS_output));

  StopInGoodOrder();
  ProgressReporter progress = MakeProgressReporter(scans->size());
  ASSIGN_OR_RETURN(Localization localization, Localize(scans.get(), relocalizer.get(), &progress));
  const auto num_scans = static_cast<int>(localization.scans.size());
  const std::string how_far = absl::StrCat("after ", num_scans, " of ", scans->size(), " scans");
  if (num_scans == 0) return absl::CancelledError(absl::StrCat(how_far, "; nothing is written"));
  Compare(*scans, places, &localization);
  context.configuration_lua = configuration.lua;
  context.map_file = FLAGS_map;
  context.scans_available = scans->size();
  context.camera_from_sensor = scans->camera_from_sensor();
  ASSIGN_OR_RETURN(context.map_sha256_after, Sha256OfFile(FLAGS_map));
  RETURN_IF_ERROR(WriteLocalizationFiles(directory, localization, context));
  if (!FLAGS_quiet) {
    PrintSummary(localization, context);
    std::cout << "output    " << directory.path() << "\n";
  }
  if (num_scans == scans->size()) return absl::OkStatus();
  return absl::CancelledError(absl::StrCat(how_far, "; their poses are in ", FLAGS_output));
}

}  // namespace

Command RelocalizeCommand() {
  Command command;
  command.name = "relocalize";
  command.summary = "where a drive is in a map, from an unknown start";
  command.description =
      "Finds the place of a drive in a finished map and follows it there, scan by scan. Without "
      "--initial_pose all of the map is searched. Where the scans stop to fit the map the pose is "
      "given up (lost), and the search begins anew. The map stays as it is.\n\n"
      "The map of another day serves best without what may have left since: see `filter "
      "--remove_role=movable`.";
  command.flags = {{"map", true},
                   {"config", false, "relocalize.lua"},
                   {"dataset", true},
                   {"sequence"},
                   {"labels_dir"},
                   {"ground_truth"},
                   {"map_ground_truth"},
                   {"initial_pose"},
                   {"first_scan"},
                   {"num_scans"},
                   {"output", true},
                   {"threads"},
                   {"quiet"}};
  command.files = {
      {"relocalization_kitti.txt",
       "Poses of the localized scans in the map, 12 numbers a line; of the camera if calib.txt has "
       "the row Tr, else of the lidar."},
      {"relocalization_tum.txt",
       "The same with times, of the lidar: each as it was known right after its scan."},
      {"smoothed_tum.txt", "The same by what came before and after."},
      {"relocalization.json",
       "State of every scan with the reason, first fix, figures, errors where the truth is known, "
       "the map's hash before and after."}};
  command.examples = {
      {"Anywhere in the map",
       "relocalize --map=lasting.pbstream --dataset=data --sequence=01 --output=output/day2"},
      {"From a known start",
       "relocalize --map=lasting.pbstream --dataset=data --initial_pose=120.5,-33,90 "
       "--output=output/day2"}};
  command.run = &RunRelocalize;
  return command;
}

}  // namespace semantic_kiss::cli
