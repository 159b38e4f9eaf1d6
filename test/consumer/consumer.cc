// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdio>

#include "cartographer/sensor/proto/label_set.pb.h"
#include "cartographer/transform/se3.h"
#include "semantic_kiss/odometry/adaptive_threshold.h"

// Exits with 0 if the installed headers, messages and libraries work together.
int main() {
  cartographer::transform::Twist twist;
  twist << 1., 2., 3., 0.1, 0.2, 0.3;
  const auto there = cartographer::transform::Exp(twist);
  const auto back = cartographer::transform::Log(there);

  cartographer::sensor::proto::LabelSet labels;
  labels.add_classes()->set_name("pole");

  semantic_kiss::odometry::proto::AdaptiveThresholdOptions options;
  options.set_initial_m(2.);
  const semantic_kiss::odometry::AdaptiveThreshold threshold(options, 100.);
  if (threshold.Sigma() != 2.) return 1;

  std::printf("%s, %s\n", there.DebugString().c_str(), labels.classes(0).name().c_str());
  return (back - twist).norm() < 1e-9 ? 0 : 1;
}
