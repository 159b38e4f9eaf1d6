// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/normal_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace cartographer::registration {
namespace {

// sum w (|s|^2 I - s s^T) = -sum w Hat(s)^2, from sum w s s^T.
Eigen::Matrix3d InertiaOf(const Eigen::Matrix3d& second_moment) {
  return second_moment.trace() * Eigen::Matrix3d::Identity() - second_moment;
}

}  // namespace

void NormalEquations::Add(const NormalEquations& other) {
  weight_ += other.weight_;
  first_moment_ += other.first_moment_;
  second_moment_ += other.second_moment_;
  residual_ += other.residual_;
  torque_ += other.torque_;
  squared_error_ += other.squared_error_;
  num_pairs_ += other.num_pairs_;
}

Eigen::Matrix<double, 6, 6> NormalEquations::Hessian() const {
  const Eigen::Matrix3d hat = transform::Hat(first_moment_);
  Eigen::Matrix<double, 6, 6> hessian;
  hessian << weight_ * Eigen::Matrix3d::Identity(), -hat,  //
      hat, InertiaOf(second_moment_);
  return hessian;
}

Eigen::Matrix<double, 6, 1> NormalEquations::Gradient() const {
  Eigen::Matrix<double, 6, 1> gradient;
  gradient << residual_, torque_;
  return gradient;
}

transform::Twist NormalEquations::Solve() const { return Hessian().ldlt().solve(-Gradient()); }

double NormalEquations::MinLeverArm() const {
  if (weight_ <= 0.) return 0.;
  const Eigen::Vector3d centroid = first_moment_ / weight_;
  const Eigen::Matrix3d scatter = second_moment_ / weight_ - centroid * centroid.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(InertiaOf(scatter),
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0., solver.eigenvalues()[0]));
}

double NormalEquations::RootMeanSquareError() const {
  return num_pairs_ == 0 ? 0. : std::sqrt(squared_error_ / num_pairs_);
}

}  // namespace cartographer::registration
