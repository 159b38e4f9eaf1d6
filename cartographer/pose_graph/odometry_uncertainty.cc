// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/odometry_uncertainty.h"

#include <algorithm>

namespace cartographer::pose_graph {
namespace {

double Square(double x) { return x * x; }

}  // namespace

OdometryUncertainty::OdometryUncertainty(const proto::OdometryErrorOptions& options,
                                         const OdometryChain& chain)
    : random_(PositiveSigmas(options.random())), systematic_(ToTwist(options.systematic())) {
  // The origin is put where the numbers are small.
  const Eigen::Vector3d origin = chain.local_from_node(0).translation();
  positions_.push_back(Eigen::Vector3d::Zero());
  length_m_.push_back(0.);
  first_moment_.push_back(Eigen::Vector3d::Zero());
  second_moment_.push_back(0.);
  for (int i = 1; i < chain.size(); ++i) {
    const Eigen::Vector3d position = chain.local_from_node(i).translation() - origin;
    const double step_m =
        std::max(options.min_step_m(), chain.distance_m(i) - chain.distance_m(i - 1));
    positions_.push_back(position);
    length_m_.push_back(length_m_.back() + step_m);
    first_moment_.push_back(first_moment_.back() + step_m * position);
    second_moment_.push_back(second_moment_.back() + step_m * position.squaredNorm());
  }
}

PoseVariance OdometryUncertainty::Between(int a, int b) const {
  const auto [start, end] = std::minmax(a, b);
  const Eigen::Vector3d& x = positions_[end];
  const double length_m = length_m_[end] - length_m_[start];
  const Eigen::Vector3d first = first_moment_[end] - first_moment_[start];
  const double second = second_moment_[end] - second_moment_[start];
  // Sums of l * |x_end - x|^2 and of l * (x_end - x).
  const double squared_levers =
      std::max(0., length_m * x.squaredNorm() - 2. * x.dot(first) + second);
  const double lever = (length_m * x - first).norm();
  const double as_the_crow_flies_m = (x - positions_[start]).norm();
  const auto translation = [](const transform::Twist& twist) { return twist.head<3>().maxCoeff(); };
  const auto rotation = [](const transform::Twist& twist) { return twist.tail<3>().maxCoeff(); };
  return {Square(translation(random_)) * length_m + Square(rotation(random_)) * squared_levers +
              Square(translation(systematic_) * as_the_crow_flies_m) +
              Square(rotation(systematic_) * lever),
          Square(rotation(random_)) * length_m + Square(rotation(systematic_) * length_m)};
}

}  // namespace cartographer::pose_graph
