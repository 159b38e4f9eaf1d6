// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/trace_odometry.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/transform/se3.h"
#include "glog/logging.h"
#include "semantic_kiss/odometry/preprocessing.h"

namespace semantic_kiss {
namespace {

using cartographer::sensor::LabeledPointCloud;
using cartographer::slam::MotionText;
using cartographer::slam::PoseText;
using cartographer::slam::ScanTrace;
using cartographer::slam::TraceStep;
using odometry::OdometryReport;
using odometry::proto::OdometryOptions;
using Placement = OdometryReport::Placement;

double SecondsOf(const OdometryReport& report, const std::string& stage) {
  for (const auto& time : report.stage_times) {
    if (time.stage == stage) return time.seconds;
  }
  return 0.;
}

std::string DeskewText(const OdometryReport& report, const OdometryOptions& options) {
  if (report.deskewed) {
    return absl::StrCat("undone: ", MotionText(cartographer::transform::Exp(report.motion)));
  }
  return options.preprocessing().deskew() ? "nothing to undo: points without times"
                                          : "switched off";
}

void TracePreprocessing(const LabeledPointCloud& scan, const OdometryReport& report,
                        const OdometryOptions& options, ScanTrace* trace) {
  TraceStep deskew{"deskew", "sensor", DeskewText(report, options)};
  deskew.Takes(cartographer::slam::kReadingStep, scan.size()).Gives(scan.size());
  trace->push_back(deskew.Took(SecondsOf(report, "preprocessing")));

  // Once more, but with all classes: what the range alone leaves.
  const LabeledPointCloud in_range =
      odometry::Preprocess(scan, report.motion, {}, options.preprocessing()).points;
  TraceStep range{"range", "sensor",
                  absl::StrFormat("%d not within %g and %g m, %d not finite",
                                  report.counts.out_of_range, options.preprocessing().min_range_m(),
                                  options.preprocessing().max_range_m(), report.counts.not_finite)};
  trace->push_back(range.Takes("deskew", scan.size()).Gives(in_range));

  TraceStep moving{"moving", "sensor",
                   absl::StrCat(report.counts.moving, " of classes that are left out")};
  trace->push_back(moving.Takes("range", in_range.size()).Gives(report.points));
}

void TraceSubsampling(const OdometryReport& report, const OdometryOptions& options,
                      ScanTrace* trace) {
  const auto text = [](const auto& subsampling) {
    return absl::StrFormat("voxels of %g m", subsampling.voxel_size_m());
  };
  TraceStep for_map{"map voxels", "sensor", text(options.map_subsampling())};
  for_map.Takes("moving", report.points.size()).Gives(report.points_for_map);
  trace->push_back(for_map.Took(SecondsOf(report, "subsampling")));
  TraceStep for_icp{"icp voxels", "sensor", text(options.icp_subsampling())};
  trace->push_back(
      for_icp.Takes("map voxels", report.points_for_map.size()).Gives(report.points_for_icp));
}

std::string RegistrationText(const OdometryReport& report) {
  if (report.placement == Placement::kFirst) return "first: there is no map yet";
  const auto& icp = report.icp;
  return absl::StrFormat(
      "%s in %d iterations: %.1f %% paired, %d agree about the label, %.3f m rms, last step %.2g",
      odometry::OutcomeName(report), icp.iterations, 100. * icp.inlier_ratio, icp.num_agreeing,
      icp.rms_error_m, icp.last_step);
}

void TraceRegistration(const OdometryReport& report, ScanTrace* trace) {
  TraceStep prediction{"prediction", "local",
                       absl::StrCat(PoseText(report.local_from_guess),
                                    absl::StrFormat("; sigma %.3f m, pairs within %.3f m",
                                                    report.sigma_m, report.gate_m))};
  trace->push_back(prediction.Took(SecondsOf(report, "registration")));
  TraceStep registration{"registration", "local", RegistrationText(report)};
  registration.Takes("icp voxels", report.points_for_icp.size());
  trace->push_back(registration.Gives(report.icp.num_correspondences));
  trace->push_back(
      {"pose", "local",
       absl::StrCat(PoseText(report.local_from_sensor), "; from the prediction ",
                    MotionText(report.local_from_guess.inverse() * report.local_from_sensor))});
}

void TraceLocalMap(const OdometryReport& report, ScanTrace* trace) {
  std::string text = absl::StrFormat("added; %d far away dropped, %d left",
                                     report.map_points_dropped, report.map_points);
  if (report.placement == Placement::kPredicted) text = "kept out: it was not registered";
  if (report.placement == Placement::kRestarted) absl::StrAppend(&text, "; begun anew");
  TraceStep step{"local map", "local", text};
  step.Takes("map voxels", report.points_for_map.size()).Gives(report.map_points_added);
  trace->push_back(step.Took(SecondsOf(report, "local_map")));
}

}  // namespace

void TraceOdometry(const LabeledPointCloud& scan, const OdometryReport& report,
                   const OdometryOptions& options, ScanTrace* trace) {
  TracePreprocessing(scan, report, options, trace);
  TraceSubsampling(report, options, trace);
  TraceRegistration(report, trace);
  TraceLocalMap(report, trace);
}

}  // namespace semantic_kiss
