// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/local_surfaces.h"

#include <Eigen/Eigenvalues>

#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

// A plane through three points fits always.
constexpr int kMinPoints = 5;

struct Moments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // the first point, for the precision of sums
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  int count = 0;

  void Add(const Eigen::Vector3d& point) {
    if (count == 0) origin = point;
    const Eigen::Vector3d offset = point - origin;
    sum += offset;
    squares += offset * offset.transpose();
    ++count;
  }
};

Eigen::Matrix3d InformationOf(const Moments& moments, double point_variance) {
  if (moments.count < kMinPoints) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d mean = moments.sum / moments.count;
  const Eigen::Matrix3d covariance = moments.squares / moments.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Array3d spread = solver.eigenvalues().array().max(0.) + point_variance;
  const Eigen::Array3d information = 1. / spread - 1. / spread[2];
  return solver.eigenvectors() * information.matrix().asDiagonal() *
         solver.eigenvectors().transpose();
}

}  // namespace

LocalSurfaces::LocalSurfaces(const sensor::LabeledPointCloud& cloud, double voxel_size_m,
                             double point_sigma_m)
    : inverse_voxel_size_(1. / voxel_size_m) {
  CHECK_GT(voxel_size_m, 0.);
  CHECK_GT(point_sigma_m, 0.);
  std::vector<Moments> moments;
  for (const Eigen::Vector3f& position : cloud.positions) {
    const Eigen::Vector3d point = position.cast<double>();
    const auto key = registration::KeyOf(registration::VoxelOf(point, inverse_voxel_size_));
    const uint32_t found = index_.FindOrInsert(key, static_cast<uint32_t>(moments.size()));
    if (found == registration::VoxelIndex::kNone) moments.emplace_back();
    (found == registration::VoxelIndex::kNone ? moments.back() : moments[found]).Add(point);
  }
  information_.reserve(moments.size());
  for (const Moments& of_voxel : moments) {
    information_.push_back(InformationOf(of_voxel, point_sigma_m * point_sigma_m).cast<float>());
  }
}

Eigen::Matrix3d LocalSurfaces::InformationAt(const Eigen::Vector3d& position) const {
  const uint32_t found =
      index_.Find(registration::KeyOf(registration::VoxelOf(position, inverse_voxel_size_)));
  if (found == registration::VoxelIndex::kNone) return Eigen::Matrix3d::Zero();
  return information_[found].cast<double>();
}

}  // namespace cartographer::pose_graph
