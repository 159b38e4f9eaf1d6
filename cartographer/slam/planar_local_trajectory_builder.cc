// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/planar_local_trajectory_builder.h"

#include <memory>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/registration/voxel_filter.h"
#include "cartographer/scan_matching/correlative_search.h"
#include "cartographer/scan_matching/fit_to_grid.h"
#include "cartographer/slam/height_band.h"
#include "cartographer/slam/trace_insertion.h"
#include "google/protobuf/message.h"

namespace cartographer::slam {
namespace {

using scan_matching::InPlane;
using scan_matching::InSpace;
using scan_matching::PlanarPose;
using sensor::LabeledPointCloud;

LabeledPointCloud PointsToMatch(const LabeledPointCloud& band,
                                const proto::AdaptiveVoxelOptions& options) {
  LabeledPointCloud near;
  const double max_squared = options.max_range_m() * options.max_range_m();
  for (size_t i = 0; i < band.size(); ++i) {
    if (band.positions[i].squaredNorm() <= max_squared) near.Append(band, i);
  }
  return registration::FilterDownTo(near, options.min_points(), options.max_voxel_size_m());
}

std::vector<Eigen::Vector2d> Flatten(const LabeledPointCloud& cloud) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(cloud.size());
  for (const Eigen::Vector3f& position : cloud.positions) {
    points.emplace_back(position.head<2>().cast<double>());
  }
  return points;
}

bool IsPlaced(const LocalResult& result) {
  return result.outcome == "first" || result.outcome == "matched";
}

}  // namespace

PlanarLocalTrajectoryBuilder::PlanarLocalTrajectoryBuilder(
    const proto::PlanarBuilderOptions& options, const sensor::LabelSet& labels)
    : options_(options),
      moving_labels_(labels.WithRole(sensor::LabelRole::kMoving)),
      motion_filter_(options.motion_filter()),
      active_submaps_(options.submaps(), labels) {}

LocalResult PlanarLocalTrajectoryBuilder::AddScan(const sensor::LabeledScan& scan) {
  LocalResult result;
  result.time = scan.time;
  common::Stopwatch stopwatch;
  const LabeledPointCloud band = CutHeightBand(scan.points, options_.height_band());
  const LabeledPointCloud matched_points = PointsToMatch(band, options_.matched_points());
  stopwatch.Lap("filters", &result.stage_times);

  Match(matched_points, &result);
  const bool first = result.outcome == "first";
  // A pose that stands for "no idea" tells no velocity.
  if (first) motion_ = PlanarMotion();
  motion_.Observe(scan.time, InPlane(result.local_from_sensor));
  stopwatch.Lap("matching", &result.stage_times);

  const bool moved = IsPlaced(result) && motion_filter_.Admit(scan.time, result.local_from_sensor);
  if (first || moved) Insert(band, matched_points, &result);
  stopwatch.Lap("submaps", &result.stage_times);
  if (trace() != nullptr) Trace(scan.points, band, matched_points, result);
  return result;
}

void PlanarLocalTrajectoryBuilder::Trace(const LabeledPointCloud& scan,
                                         const LabeledPointCloud& band,
                                         const LabeledPointCloud& matched_points,
                                         const LocalResult& result) const {
  TraceStep cut{"height band", "sensor", "what lies between two heights"};
  cut.Takes(kReadingStep, scan.size()).Gives(band);
  trace()->push_back(cut.Took(result.stage_times[0].seconds));
  TraceStep thinned{"matched points", "sensor", "near ones, thinned out"};
  trace()->push_back(thinned.Takes("height band", band.size()).Gives(matched_points));
  TraceStep matching{"matching", "local",
                     absl::StrCat(result.outcome, ": ", PoseText(result.local_from_sensor))};
  matching.Takes("matched points", matched_points.size());
  trace()->push_back(matching.Took(result.stage_times[1].seconds));
  TraceInsertion(
      result,
      {band, "height band", matched_points, "matched points", moving_labels_, IsPlaced(result)},
      result.stage_times[2].seconds, trace());
}

void PlanarLocalTrajectoryBuilder::Match(const LabeledPointCloud& matched_points,
                                         LocalResult* result) const {
  result->local_from_sensor = InSpace(motion_.Predict(result->time));
  const auto reference = active_submaps_.reference();
  if (reference.grid == nullptr || reference.grid->bounds().Empty()) {
    result->outcome = "first";
    return;
  }
  if (matched_points.size() < static_cast<size_t>(options_.min_points())) {
    result->outcome = "too_few_points";
    return;
  }
  const std::vector<Eigen::Vector2d> points = Flatten(matched_points);
  const PlanarPose expected =
      InPlane(reference.local_from_submap.inverse() * result->local_from_sensor);
  const auto& search =
      motion_.IsKnown() ? options_.correlative_search() : options_.initial_search();
  PlanarPose guess = expected;
  if (search.enabled()) guess = SearchAround(*reference.grid, points, expected, search);
  const scan_matching::GridFit fit = FitToGrid(
      *reference.grid, points, motion_.IsKnown() ? expected : guess, guess, options_.fit());
  result->outcome = fit.usable ? "matched" : "no_fit";
  if (fit.usable) {
    result->local_from_sensor = reference.local_from_submap * InSpace(fit.grid_from_scan);
  }
}

void PlanarLocalTrajectoryBuilder::Insert(const LabeledPointCloud& band,
                                          const LabeledPointCloud& matched_points,
                                          LocalResult* result) {
  result->insertion.emplace();
  result->insertion->submaps = active_submaps_.AddScan(band, result->local_from_sensor);
  result->insertion->cloud = std::make_shared<const LabeledPointCloud>(
      sensor::WithoutLabels(matched_points, moving_labels_));
}

void PlanarLocalTrajectoryBuilder::Finish() { active_submaps_.FinishAll(); }

void RegisterPlanarLocalTrajectoryBuilder(LocalTrajectoryBuilderRegistry* registry) {
  registry->Register(
      "planar",
      [](const google::protobuf::Message& options, const sensor::LabelSet& labels)
          -> absl::StatusOr<std::unique_ptr<LocalTrajectoryBuilder>> {
        const auto* const planar_options =
            dynamic_cast<const proto::PlanarBuilderOptions*>(&options);
        if (planar_options == nullptr) {
          return absl::InvalidArgumentError(
              absl::StrCat("options of \"planar\" are of type ", options.GetTypeName(),
                           " in place of cartographer.slam.proto.PlanarBuilderOptions"));
        }
        return std::make_unique<PlanarLocalTrajectoryBuilder>(*planar_options, labels);
      });
}

}  // namespace cartographer::slam
