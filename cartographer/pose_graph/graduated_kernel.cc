// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/graduated_kernel.h"

#include <algorithm>
#include <limits>

#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

// Slower narrowing takes more steps and, on graphs of which half the loops are wrong, finds no
// more.
constexpr double kNarrowing = 4.;

}  // namespace

GraduatedKernel::GraduatedKernel(double squared_scale)
    : squared_scale_(squared_scale), mu_(std::numeric_limits<double>::infinity()) {
  CHECK_GT(squared_scale, 0.);
}

void GraduatedKernel::Narrow(const std::vector<double>& squared_errors) {
  double largest = 0.;
  for (const double error : squared_errors) largest = std::max(largest, error);
  // With 2 * largest / s the cost is convex up to there (as in the source).
  mu_ = std::max(1., std::min(mu_ / kNarrowing, 2. * largest / squared_scale_));
}

double GraduatedKernel::Weight(double squared_error) const {
  const double width = mu_ * squared_scale_;
  const double ratio = width / (width + squared_error);
  return ratio * ratio;
}

double GraduatedKernel::Cost(double squared_error) const {
  return 0.5 * squared_scale_ * squared_error / (squared_scale_ + squared_error);
}

}  // namespace cartographer::pose_graph
