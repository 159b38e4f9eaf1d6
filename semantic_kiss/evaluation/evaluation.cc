// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/evaluation.h"

#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

absl::Status CheckFinite(absl::string_view name, const std::vector<Rigid3d>& poses) {
  for (size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i].IsFinite()) {
      return absl::InvalidArgumentError(
          absl::StrCat("pose ", i, " of the ", name, " is not finite: ", poses[i].DebugString(),
                       "; leave out scans without a pose on both sides"));
    }
  }
  return absl::OkStatus();
}

absl::Status CheckComparable(const std::vector<Rigid3d>& ground_truth,
                             const std::vector<Rigid3d>& estimate) {
  if (ground_truth.size() != estimate.size()) {
    return absl::InvalidArgumentError(absl::StrCat("the ground truth has ", ground_truth.size(),
                                                   " poses, the estimate ", estimate.size(),
                                                   "; give the range of scans that was estimated"));
  }
  if (estimate.empty()) {
    return absl::InvalidArgumentError("there are no poses to compare; give at least one");
  }
  RETURN_IF_ERROR(CheckFinite("ground truth", ground_truth));
  return CheckFinite("estimate", estimate);
}

}  // namespace

Metrics MetricsOf(const Evaluation& evaluation) {
  Metrics metrics;
  if (evaluation.relative) {
    metrics.rte_percent = evaluation.relative->overall.translation_percent;
    metrics.rte_deg_per_m = evaluation.relative->overall.rotation_deg_per_m;
  }
  if (evaluation.absolute_3d) metrics.ate_3d_m = evaluation.absolute_3d->rmse_m;
  if (evaluation.absolute_2d) metrics.ate_2d_m = evaluation.absolute_2d->rmse_m;
  return metrics;
}

absl::StatusOr<std::vector<Rigid3d>> GroundTruthOfScans(const std::vector<Rigid3d>& ground_truth,
                                                        int first_scan,
                                                        std::optional<int> num_scans) {
  const int64_t available = static_cast<int64_t>(ground_truth.size()) - first_scan;
  const int64_t wanted = num_scans.value_or(available);
  if (first_scan < 0 || wanted < 0 || wanted > available) {
    const std::string count = num_scans ? absl::StrCat(*num_scans) : "all";
    return absl::OutOfRangeError(absl::StrCat("the ground truth has ", ground_truth.size(),
                                              " poses; ", count, " from pose ", first_scan,
                                              " on are not among them; choose scans within it"));
  }
  const auto begin = ground_truth.begin() + first_scan;
  return std::vector<Rigid3d>(begin, begin + wanted);
}

absl::Status CheckSameBody(const std::vector<Rigid3d>& ground_truth,
                           const std::vector<Rigid3d>& estimate) {
  const std::optional<VehicleFrame> true_frame = GuessVehicleFrame(ground_truth);
  const std::optional<VehicleFrame> frame = GuessVehicleFrame(estimate);
  if (!true_frame || !frame || *true_frame == *frame) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(
      "the ground truth holds poses of a ", NameOf(*true_frame), ", the estimate of a ",
      NameOf(*frame), " (by the axis along which it drives); give the calibration between them"));
}

absl::StatusOr<Evaluation> Evaluate(const std::vector<Rigid3d>& ground_truth,
                                    const std::vector<Rigid3d>& estimate, VehicleFrame frame) {
  RETURN_IF_ERROR(CheckComparable(ground_truth, estimate));
  Evaluation evaluation;
  evaluation.driven_m = DrivenDistances(ground_truth).back();
  evaluation.relative = ComputeRelativeErrors(ground_truth, estimate);
  evaluation.absolute_3d = ComputeAbsoluteError3d(ground_truth, estimate);
  evaluation.absolute_2d = ComputeAbsoluteError2d(ground_truth, estimate, frame);
  evaluation.final_error = ComputeFinalError(ground_truth, estimate, frame);
  return evaluation;
}

}  // namespace semantic_kiss::evaluation
