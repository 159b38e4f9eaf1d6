// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/odometry.h"

#include <utility>

#include "glog/logging.h"
#include "semantic_kiss/odometry/class_subsampling.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::LabelSet;

// KISS-ICP is our odometry with everything switched off that asks for labels.
proto::OdometryOptions ResolveMode(proto::OdometryOptions options) {
  if (options.mode() == "kiss_icp") {
    options.mutable_preprocessing()->set_drop_moving(false);
    options.mutable_preprocessing()->clear_drop_labels();
    options.clear_critical_labels();
    options.mutable_map_subsampling()->clear_class_voxels();
    options.mutable_icp_subsampling()->clear_class_voxels();
    options.mutable_map_subsampling()->set_max_critical_points_per_voxel(0);
    options.mutable_icp_subsampling()->set_max_critical_points_per_voxel(0);
    options.mutable_local_map()->set_max_critical_points_per_voxel(0);
    options.mutable_local_map()->set_displace_unlabeled(false);
    options.mutable_icp()->set_weight_by_certainty(false);
    options.mutable_icp()->set_agreeing_distance_factor(1.);
  }
  return options;
}

LabelRules RulesOf(const proto::OdometryOptions& options, const LabelSet& labels) {
  absl::StatusOr<LabelRules> rules = LabelRules::Create(options, labels);
  CHECK(rules.ok()) << rules.status();
  return *std::move(rules);
}

}  // namespace

absl::string_view OutcomeName(const OdometryReport& report) {
  switch (report.placement) {
    case OdometryReport::Placement::kFirst:
      return "first";
    case OdometryReport::Placement::kRestarted:
      return "restarted";
    case OdometryReport::Placement::kRegistered:
    case OdometryReport::Placement::kPredicted:
      break;
  }
  return cartographer::registration::OutcomeName(report.icp.outcome);
}

Odometry::Odometry(const proto::OdometryOptions& options, const LabelSet& labels)
    : options_(ResolveMode(options)),
      rules_(RulesOf(options_, labels)),
      local_map_(options_.local_map(), rules_.critical),
      threshold_(options_.adaptive_threshold(), options_.preprocessing().max_range_m()) {}

OdometryReport Odometry::AddScan(const cartographer::sensor::LabeledPointCloud& scan) {
  OdometryReport report;
  cartographer::common::Stopwatch stopwatch;
  report.motion = motion_.Motion();
  PreprocessedScan preprocessed =
      Preprocess(scan, report.motion, rules_.dropped, options_.preprocessing());
  report.points = std::move(preprocessed.points);
  report.counts = preprocessed.counts;
  report.deskewed = preprocessed.deskewed;
  stopwatch.Lap("preprocessing", &report.stage_times);

  SubsampleScan(&report);
  stopwatch.Lap("subsampling", &report.stage_times);

  Register(&report);
  motion_.Observe(report.local_from_sensor);
  stopwatch.Lap("registration", &report.stage_times);

  UpdateLocalMap(&report);
  stopwatch.Lap("local_map", &report.stage_times);
  return report;
}

void Odometry::SubsampleScan(OdometryReport* report) const {
  report->points_for_map = SubsampleByClass(report->points, options_.map_subsampling(),
                                            rules_.map_classes, rules_.critical);
  report->points_for_icp = SubsampleByClass(report->points_for_map, options_.icp_subsampling(),
                                            rules_.icp_classes, rules_.critical);
}

void Odometry::Register(OdometryReport* report) {
  using Placement = OdometryReport::Placement;
  const auto local_from_guess = motion_.Predict();
  report->local_from_guess = local_from_guess;
  report->local_from_sensor = local_from_guess;
  report->sigma_m = threshold_.Sigma();
  report->gate_m = threshold_.Gate();
  if (local_map_.Empty()) {
    report->placement = Placement::kFirst;
    return;
  }
  report->icp = AlignCloud(report->points_for_icp, local_map_, local_from_guess,
                           {report->gate_m, threshold_.KernelScale()}, options_.icp());
  if (report->icp.HasEstimate()) {
    report->placement = Placement::kRegistered;
    report->local_from_sensor = report->icp.map_from_source;
    threshold_.Observe(local_from_guess.inverse() * report->local_from_sensor,
                       report->local_from_sensor.translation().norm());
    failures_in_a_row_ = 0;
  } else if (++failures_in_a_row_ >= options_.restart_after_failures()) {
    report->placement = Placement::kRestarted;
    failures_in_a_row_ = 0;
  }
}

void Odometry::UpdateLocalMap(OdometryReport* report) {
  report->map_points = local_map_.num_points();
  if (report->placement == OdometryReport::Placement::kPredicted) return;
  if (report->placement == OdometryReport::Placement::kRestarted) local_map_.Clear();
  const size_t before = local_map_.num_points();
  local_map_.Insert(report->points_for_map, report->local_from_sensor);
  report->map_points_added = local_map_.num_points() - before;
  local_map_.RemoveFarFrom(report->local_from_sensor.translation(),
                           options_.preprocessing().max_range_m());
  report->map_points = local_map_.num_points();
  report->map_points_dropped = before + report->map_points_added - report->map_points;
}

}  // namespace semantic_kiss::odometry
