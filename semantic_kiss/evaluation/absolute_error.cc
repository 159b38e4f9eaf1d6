// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/absolute_error.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "glog/logging.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

template <int kDimension>
using Positions = Eigen::Matrix<double, kDimension, Eigen::Dynamic>;

Positions<3> PositionsOf(const std::vector<Rigid3d>& poses) {
  Positions<3> positions(3, poses.size());
  for (size_t i = 0; i < poses.size(); ++i) positions.col(i) = poses[i].translation();
  return positions;
}

Positions<2> PlanePositionsOf(const std::vector<Rigid3d>& poses, VehicleFrame frame) {
  const Rigid3d first_from_world = poses.front().inverse();
  const int second_axis = frame == VehicleFrame::kCamera ? 2 : 1;
  Positions<2> positions(2, poses.size());
  for (size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d position = first_from_world * poses[i].translation();
    positions.col(i) << position.x(), position[second_axis];
  }
  return positions;
}

// The rotation that turns centered positions `estimate` as close as possible to `truth`. Where the
// positions leave some of it open (a straight line), any that fits.
template <int kDimension>
Eigen::Matrix<double, kDimension, kDimension> BestRotation(const Positions<kDimension>& truth,
                                                           const Positions<kDimension>& estimate) {
  using Square = Eigen::Matrix<double, kDimension, kDimension>;
  const Square covariance = truth * estimate.transpose();
  const Eigen::JacobiSVD<Square> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  // Without this the best fit may be a mirror image.
  Eigen::Matrix<double, kDimension, 1> signs = Eigen::Matrix<double, kDimension, 1>::Ones();
  if ((svd.matrixU() * svd.matrixV()).determinant() < 0.) signs[kDimension - 1] = -1.;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

template <int kDimension>
AbsoluteError ErrorAfterAlignment(Positions<kDimension> truth, Positions<kDimension> estimate) {
  CHECK(truth.allFinite() && estimate.allFinite());
  truth.colwise() -= truth.rowwise().mean().eval();
  estimate.colwise() -= estimate.rowwise().mean().eval();
  const Positions<kDimension> deviations = BestRotation(truth, estimate) * estimate - truth;

  AbsoluteError error;
  error.deviations = deviations;
  error.rmse_m = std::sqrt(deviations.squaredNorm() / deviations.cols());
  for (Eigen::Index i = 0; i < deviations.cols(); ++i) {
    error.errors_m.push_back(deviations.col(i).norm());
  }
  return error;
}

}  // namespace

std::optional<AbsoluteError> ComputeAbsoluteError3d(const std::vector<Rigid3d>& ground_truth,
                                                    const std::vector<Rigid3d>& estimate) {
  CHECK_EQ(ground_truth.size(), estimate.size());
  if (estimate.size() < kMinPosesOfAbsoluteError) return std::nullopt;
  return ErrorAfterAlignment<3>(PositionsOf(ground_truth), PositionsOf(estimate));
}

std::optional<AbsoluteError> ComputeAbsoluteError2d(const std::vector<Rigid3d>& ground_truth,
                                                    const std::vector<Rigid3d>& estimate,
                                                    VehicleFrame frame) {
  CHECK_EQ(ground_truth.size(), estimate.size());
  if (estimate.size() < kMinPosesOfAbsoluteError) return std::nullopt;
  return ErrorAfterAlignment<2>(PlanePositionsOf(ground_truth, frame),
                                PlanePositionsOf(estimate, frame));
}

}  // namespace semantic_kiss::evaluation
