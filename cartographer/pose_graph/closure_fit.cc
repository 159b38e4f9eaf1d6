// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/closure_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "cartographer/transform/se3.h"

namespace cartographer::pose_graph {
namespace {

using registration::LabeledVoxelMap;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double kRadiansPerDegree = M_PI / 180.;

// Sums over the pairs of a cloud.
struct Sums {
  int num_judged = 0;
  int num_overlapping = 0;
  int num_inliers = 0;
  double squared_error = 0.;
  Matrix6d hessian = Matrix6d::Zero();

  // A point of the cloud and what its neighbour tells, in the cloud's frame.
  void AddInformation(const Eigen::Vector3d& point, const Eigen::Matrix3d& information) {
    const Eigen::Matrix3d hat = transform::Hat(point);
    const Eigen::Matrix3d torque = hat * information;
    hessian.topLeftCorner<3, 3>() += information;
    hessian.bottomLeftCorner<3, 3>() += torque;
    hessian.bottomRightCorner<3, 3>() -= torque * hat;
  }
};

Matrix6d DiagonalOf(double sigma_m, double sigma_deg) {
  const double sigma_rad = sigma_deg * kRadiansPerDegree;
  Eigen::Matrix<double, 6, 1> variances;
  variances << Eigen::Vector3d::Constant(sigma_m * sigma_m),
      Eigen::Vector3d::Constant(sigma_rad * sigma_rad);
  return variances.asDiagonal();
}

Matrix6d Inverse(const Matrix6d& matrix) {
  return matrix.selfadjointView<Eigen::Lower>().llt().solve(Matrix6d::Identity());
}

double LargestSigma(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0., solver.eigenvalues()[2]));
}

Sums SumOverPoints(const sensor::LabeledPointCloud& cloud,
                   const transform::Rigid3d& target_from_node, const ClosureTarget& target,
                   const proto::AcceptanceOptions& options) {
  const Eigen::Matrix3d rotation = target_from_node.rotation().toRotationMatrix();
  const double max_squared_range = options.max_range_m() * options.max_range_m();
  const double inlier_squared = options.inlier_distance_m() * options.inlier_distance_m();
  Sums sums;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d in_node = cloud.positions[i].cast<double>();
    if (in_node.squaredNorm() > max_squared_range) continue;
    const Eigen::Vector3d point = rotation * in_node + target_from_node.translation();
    if (!target.box().contains(point)) continue;
    const bool judged = !target.ground_labels().Contains(cloud.labels[i]);
    sums.num_judged += judged ? 1 : 0;
    const std::optional<LabeledVoxelMap::Neighbor> neighbor =
        target.points().FindNearest(point, options.overlap_distance_m()).neighbor;
    if (!neighbor.has_value()) continue;
    sums.num_overlapping += judged ? 1 : 0;
    const double squared_distance = (neighbor->position - point).squaredNorm();
    if (squared_distance > inlier_squared || !sensor::LabelsAgree(cloud.labels[i], neighbor->label))
      continue;
    sums.AddInformation(
        in_node,
        rotation.transpose() * target.surfaces().InformationAt(neighbor->position) * rotation);
    if (!judged) continue;
    ++sums.num_inliers;
    sums.squared_error += squared_distance;
  }
  return sums;
}

double Ratio(double part, double whole) { return whole == 0. ? 0. : part / whole; }

}  // namespace

ClosureFit JudgeFit(const sensor::LabeledPointCloud& cloud,
                    const transform::Rigid3d& target_from_node, const ClosureTarget& target,
                    const proto::VerificationOptions& options) {
  const Sums sums = SumOverPoints(cloud, target_from_node, target, options.acceptance());
  const proto::InformationOptions& information = options.information();
  const Matrix6d measured =
      sums.hessian / information.pairs_per_measurement() +
      Inverse(DiagonalOf(information.prior_sigma_m(), information.prior_sigma_deg()));
  const Matrix6d covariance =
      Inverse(measured) + DiagonalOf(information.floor_sigma_m(), information.floor_sigma_deg());

  ClosureFit fit;
  fit.num_judged = sums.num_judged;
  fit.overlap = Ratio(sums.num_overlapping, sums.num_judged);
  fit.inlier_ratio = Ratio(sums.num_inliers, sums.num_overlapping);
  fit.rms_error_m = std::sqrt(Ratio(sums.squared_error, sums.num_inliers));
  fit.information = Inverse(covariance);
  fit.max_sigma_m = LargestSigma(covariance.topLeftCorner<3, 3>());
  fit.max_sigma_rad = LargestSigma(covariance.bottomRightCorner<3, 3>());
  return fit;
}

}  // namespace cartographer::pose_graph
