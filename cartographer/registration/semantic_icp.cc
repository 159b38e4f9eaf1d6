// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/semantic_icp.h"

#include <vector>

#include "cartographer/common/parallel.h"
#include "cartographer/registration/correspondence_search.h"
#include "cartographer/registration/normal_equations.h"
#include "cartographer/transform/se3.h"
#include "glog/logging.h"

namespace cartographer::registration {
namespace {

using transform::Rigid3d;

// Small enough to spread a sub-sampled scan over many threads, large enough to make scheduling
// negligible. The value decides the order of the sums, hence the last bits of the result.
constexpr size_t kPointsPerChunk = 256;

struct PairSums {
  NormalEquations equations;
  int num_agreeing = 0;

  void Add(const PairSums& other) {
    equations.Add(other.equations);
    num_agreeing += other.num_agreeing;
  }
};

// Pairs the points of [begin, end) with the map and sums their equations, about the position of
// the source's frame.
PairSums SumPairs(const sensor::LabeledPointCloud& source, size_t begin, size_t end,
                  const Rigid3d& map_from_source, double kernel_scale,
                  const proto::IcpOptions& options, CorrespondenceSearch* search) {
  const Eigen::Matrix3d rotation = map_from_source.rotation().toRotationMatrix();
  const Eigen::Vector3d& origin = map_from_source.translation();
  PairSums sums;
  for (size_t i = begin; i < end; ++i) {
    const Eigen::Vector3d arm = rotation * source.positions[i].cast<double>();
    const auto neighbor = search->Find(i, arm + origin, source.labels[i]);
    if (!neighbor.has_value()) continue;
    const Eigen::Vector3d target = neighbor->position - origin;
    double weight = GemanMcClureWeight((arm - target).squaredNorm(), kernel_scale);
    if (options.weight_by_certainty()) {
      weight *= CertaintyWeight(source.labels[i], source.certainties[i], neighbor->label,
                                options.unlabeled_weight());
    }
    sums.equations.AddPair(arm, target, weight);
    const bool agree = source.labels[i] == neighbor->label && neighbor->label != sensor::kUnlabeled;
    sums.num_agreeing += agree ? 1 : 0;
  }
  return sums;
}

PairSums SumAllPairs(const sensor::LabeledPointCloud& source, const Rigid3d& map_from_source,
                     double kernel_scale, const proto::IcpOptions& options,
                     CorrespondenceSearch* search) {
  PairSums sum;
  for (const PairSums& part : common::ParallelMapChunks<PairSums>(
           source.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
             return SumPairs(source, begin, end, map_from_source, kernel_scale, options, search);
           })) {
    sum.Add(part);
  }
  return sum;
}

Rigid3d StepAboutOrigin(const transform::Twist& step, const Rigid3d& map_from_source) {
  const Rigid3d motion = transform::Exp(step);
  return Rigid3d(motion.translation() + map_from_source.translation(),
                 motion.rotation() * map_from_source.rotation());
}

IcpReport Failure(IcpOutcome outcome, const Rigid3d& map_from_guess, IcpReport report) {
  report.outcome = outcome;
  report.map_from_source = map_from_guess;
  return report;
}

}  // namespace

absl::string_view OutcomeName(IcpOutcome outcome) {
  switch (outcome) {
    case IcpOutcome::kConverged:
      return "converged";
    case IcpOutcome::kIterationLimit:
      return "iteration_limit";
    case IcpOutcome::kTooFewPoints:
      return "too_few_points";
    case IcpOutcome::kNoCorrespondences:
      return "no_correspondences";
    case IcpOutcome::kDegenerate:
      return "degenerate";
  }
  LOG(FATAL) << "Unknown outcome " << static_cast<int>(outcome);
}

double CertaintyWeight(sensor::Label source, float certainty, sensor::Label target,
                       double unlabeled_weight) {
  if (source == sensor::kUnlabeled || target == sensor::kUnlabeled) return unlabeled_weight;
  return source == target ? certainty : 1. - certainty;
}

IcpReport AlignCloud(const sensor::LabeledPointCloud& source, const LabeledVoxelMap& map,
                     const Rigid3d& map_from_guess, const IcpScale& scale,
                     const proto::IcpOptions& options) {
  CHECK_GT(scale.gate_m, 0.);
  CHECK_GT(scale.kernel_scale, 0.);
  CHECK_GT(options.agreeing_distance_factor(), 0.);
  IcpReport report;
  report.map_from_source = map_from_guess;
  if (source.size() < static_cast<size_t>(options.min_points())) return report;

  CorrespondenceSearch search(map, scale.gate_m, options.agreeing_distance_factor(), source.size());
  while (report.iterations < options.max_iterations()) {
    const PairSums sums =
        SumAllPairs(source, report.map_from_source, scale.kernel_scale, options, &search);
    const NormalEquations& equations = sums.equations;
    ++report.iterations;
    report.num_agreeing = sums.num_agreeing;
    report.num_correspondences = equations.num_pairs();
    report.inlier_ratio = static_cast<double>(equations.num_pairs()) / source.size();
    report.rms_error_m = equations.RootMeanSquareError();
    if (equations.num_pairs() < options.min_correspondences() || equations.weight() <= 0.) {
      return Failure(IcpOutcome::kNoCorrespondences, map_from_guess, report);
    }
    if (!(equations.MinLeverArm() > options.min_lever_arm_m())) {
      return Failure(IcpOutcome::kDegenerate, map_from_guess, report);
    }
    const transform::Twist step = equations.Solve();
    report.map_from_source = StepAboutOrigin(step, report.map_from_source);
    report.last_step = step.norm();
    if (report.last_step < options.convergence_threshold()) {
      report.outcome = IcpOutcome::kConverged;
      return report;
    }
  }
  report.outcome = IcpOutcome::kIterationLimit;
  return report;
}

}  // namespace cartographer::registration
