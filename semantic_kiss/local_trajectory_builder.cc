// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/local_trajectory_builder.h"

#include <memory>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/slam/trace_insertion.h"
#include "google/protobuf/message.h"
#include "semantic_kiss/odometry/label_rules.h"
#include "semantic_kiss/trace_odometry.h"

namespace semantic_kiss {

using cartographer::sensor::LabeledPointCloud;
using cartographer::slam::LocalResult;

LocalTrajectoryBuilder::LocalTrajectoryBuilder(const proto::SemanticKissOptions& options,
                                               const cartographer::sensor::LabelSet& labels)
    : moving_labels_(labels.WithRole(cartographer::sensor::LabelRole::kMoving)),
      odometry_options_(options.odometry()),
      odometry_(options.odometry(), labels),
      motion_filter_(options.motion_filter()),
      active_submaps_(options.submaps(), labels) {}

LocalResult LocalTrajectoryBuilder::AddScan(const cartographer::sensor::LabeledScan& scan) {
  cartographer::common::Stopwatch stopwatch;
  odometry::OdometryReport report = odometry_.AddScan(scan.points);
  LocalResult result;
  result.time = scan.time;
  result.local_from_sensor = report.local_from_sensor;
  result.outcome = std::string(odometry::OutcomeName(report));
  stopwatch.Lap("odometry", &result.stage_times);
  for (cartographer::common::StageTime& step : report.stage_times) {
    result.stage_times.push_back({absl::StrCat("odometry/", step.stage), step.seconds});
  }

  using Placement = odometry::OdometryReport::Placement;
  // What was mapped before is somewhere else, relative to what comes now, than the poses tell.
  if (report.placement == Placement::kRestarted) active_submaps_.FinishAll();
  const bool placed = report.placement != Placement::kPredicted;
  if (placed && motion_filter_.Admit(scan.time, report.local_from_sensor)) Insert(report, &result);
  stopwatch.Lap("submaps", &result.stage_times);
  if (trace() != nullptr) Trace(scan.points, report, result);
  return result;
}

void LocalTrajectoryBuilder::Insert(const odometry::OdometryReport& report, LocalResult* result) {
  result->insertion.emplace();
  result->insertion->submaps =
      active_submaps_.AddScan(report.points, report.points_for_map, report.local_from_sensor);
  result->insertion->cloud = std::make_shared<const LabeledPointCloud>(
      cartographer::sensor::WithoutLabels(report.points_for_icp, moving_labels_));
}

void LocalTrajectoryBuilder::Trace(const LabeledPointCloud& scan,
                                   const odometry::OdometryReport& report,
                                   const LocalResult& result) const {
  TraceOdometry(scan, report, odometry_options_, trace());
  cartographer::slam::TraceInsertion(
      result,
      {report.points, "moving", report.points_for_icp, "icp voxels", moving_labels_,
       report.placement != odometry::OdometryReport::Placement::kPredicted},
      result.stage_times.back().seconds, trace());
}

void LocalTrajectoryBuilder::Finish() { active_submaps_.FinishAll(); }

void RegisterLocalTrajectoryBuilder(cartographer::slam::LocalTrajectoryBuilderRegistry* registry) {
  registry->Register(
      "semantic_kiss",
      [](const google::protobuf::Message& options, const cartographer::sensor::LabelSet& labels)
          -> absl::StatusOr<std::unique_ptr<cartographer::slam::LocalTrajectoryBuilder>> {
        const auto* const semantic_kiss_options =
            dynamic_cast<const proto::SemanticKissOptions*>(&options);
        if (semantic_kiss_options == nullptr) {
          return absl::InvalidArgumentError(
              absl::StrCat("options of \"semantic_kiss\" are of type ", options.GetTypeName(),
                           " in place of semantic_kiss.proto.SemanticKissOptions"));
        }
        RETURN_IF_ERROR(cartographer::common::AddContext(
            odometry::LabelRules::Create(semantic_kiss_options->odometry(), labels).status(),
            "local_trajectory_builder.semantic_kiss.odometry"));
        return std::make_unique<LocalTrajectoryBuilder>(*semantic_kiss_options, labels);
      });
}

}  // namespace semantic_kiss
