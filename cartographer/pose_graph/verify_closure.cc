// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/verify_closure.h"

#include <cmath>

#include "cartographer/pose_graph/closure_fit.h"
#include "cartographer/pose_graph/height_offset.h"
#include "cartographer/registration/semantic_icp.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

using registration::IcpReport;
using transform::Rigid3d;

constexpr double kDegreesPerRadian = 180. / M_PI;

std::optional<double> HeightOffsetAt(const Rigid3d& submap_from_node,
                                     const sensor::LabeledPointCloud& cloud,
                                     const ClosureTarget& target,
                                     const proto::GroundOptions& options) {
  const auto offset =
      FindHeightOffset(cloud, submap_from_node, target.ground(), target.ground_labels(), options);
  if (!offset.has_value()) return std::nullopt;
  return offset->offset_m;
}

// From coarse to fine; the report of the last stage that ran.
IcpReport Register(const sensor::LabeledPointCloud& cloud, const Rigid3d& guess,
                   const ClosureTarget& target, const proto::VerificationOptions& options) {
  IcpReport report;
  report.map_from_source = guess;
  for (const proto::AlignmentStage& stage : options.stages()) {
    report = registration::AlignCloud(cloud, target.points(), report.map_from_source,
                                      {stage.gate_m(), stage.kernel_scale()}, options.icp());
    if (!report.HasEstimate()) break;
  }
  return report;
}

Verdict Judge(const ClosureReport& report, int num_judged,
              const proto::AcceptanceOptions& options) {
  if (num_judged < options.min_points()) return Verdict::kTooFewPoints;
  if (report.overlap < options.min_overlap()) return Verdict::kLowOverlap;
  if (report.inlier_ratio < options.min_inlier_ratio()) return Verdict::kLowInlierRatio;
  if (report.rms_error_m > options.max_rms_error_m()) return Verdict::kLargeError;
  if (report.correction_m > options.max_correction_m() ||
      report.correction_deg > options.max_correction_deg()) {
    return Verdict::kLargeCorrection;
  }
  if (std::abs(report.height_mismatch_m.value_or(0.)) > options.max_height_mismatch_m()) {
    return Verdict::kHeightMismatch;
  }
  if (report.max_sigma_m > options.max_sigma_m() ||
      report.max_sigma_deg > options.max_sigma_deg()) {
    return Verdict::kDegenerate;
  }
  return Verdict::kAccepted;
}

void Log(const ClosureReport& report) {
  VLOG(1) << "Closure candidate: " << VerdictName(report.verdict) << "; overlap " << report.overlap
          << ", inliers " << report.inlier_ratio << ", rms " << report.rms_error_m
          << " m, corrected by " << report.correction_m << " m, " << report.correction_deg
          << " degrees, sigma up to " << report.max_sigma_m << " m, " << report.max_sigma_deg
          << " degrees";
}

}  // namespace

absl::string_view VerdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::kAccepted:
      return "accepted";
    case Verdict::kIcpFailed:
      return "icp_failed";
    case Verdict::kTooFewPoints:
      return "too_few_points";
    case Verdict::kLowOverlap:
      return "low_overlap";
    case Verdict::kLowInlierRatio:
      return "low_inlier_ratio";
    case Verdict::kLargeError:
      return "large_error";
    case Verdict::kLargeCorrection:
      return "large_correction";
    case Verdict::kHeightMismatch:
      return "height_mismatch";
    case Verdict::kDegenerate:
      return "degenerate";
  }
  LOG(FATAL) << "Unknown verdict " << static_cast<int>(verdict);
}

ClosureReport VerifyClosure(const sensor::LabeledPointCloud& cloud,
                            const Rigid3d& submap_from_node_guess, const ClosureTarget& target,
                            const proto::VerificationOptions& options) {
  ClosureReport report;
  report.submap_from_node = submap_from_node_guess;
  report.height_offset_m = HeightOffsetAt(submap_from_node_guess, cloud, target, options.ground());
  const Rigid3d lifted =
      Rigid3d::Translation({0., 0., report.height_offset_m.value_or(0.)}) * submap_from_node_guess;
  const IcpReport icp = Register(cloud, lifted, target, options);
  if (!icp.HasEstimate()) {
    Log(report);
    return report;
  }
  report.submap_from_node = icp.map_from_source;
  const Rigid3d correction = lifted.inverse() * icp.map_from_source;
  report.correction_m = (icp.map_from_source.translation() - lifted.translation()).head<2>().norm();
  report.correction_deg = transform::RotationAngle(correction) * kDegreesPerRadian;
  report.height_mismatch_m =
      HeightOffsetAt(report.submap_from_node, cloud, target, options.ground());

  const ClosureFit fit = JudgeFit(cloud, report.submap_from_node, target, options);
  report.overlap = fit.overlap;
  report.inlier_ratio = fit.inlier_ratio;
  report.rms_error_m = fit.rms_error_m;
  report.information = fit.information;
  report.max_sigma_m = fit.max_sigma_m;
  report.max_sigma_deg = fit.max_sigma_rad * kDegreesPerRadian;
  report.verdict = Judge(report, fit.num_judged, options.acceptance());
  Log(report);
  return report;
}

}  // namespace cartographer::pose_graph
