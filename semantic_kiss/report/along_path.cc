// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/along_path.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "glog/logging.h"

namespace semantic_kiss::report {
namespace {

using cartographer::transform::Rigid3d;
using Poses = std::vector<Rigid3d>;

// Poses to each side of the one whose speed it is.
constexpr int kSpeedReach = 3;

Eigen::Matrix3Xd Positions(const Poses& poses) {
  Eigen::Matrix3Xd positions(3, poses.size());
  for (size_t i = 0; i < poses.size(); ++i) positions.col(i) = poses[i].translation();
  return positions;
}

}  // namespace

std::vector<Eigen::Vector2d> PlanePositions(const Poses& poses) {
  std::vector<Eigen::Vector2d> positions;
  for (const Rigid3d& pose : poses) positions.push_back(pose.translation().head<2>());
  return positions;
}

std::vector<double> Heights(const Poses& poses) {
  std::vector<double> heights;
  for (const Rigid3d& pose : poses) {
    heights.push_back(pose.translation().z() - poses.front().translation().z());
  }
  return heights;
}

std::vector<double> Speeds(const std::vector<cartographer::common::Time>& times,
                           const Poses& poses) {
  CHECK_EQ(times.size(), poses.size());
  const int size = static_cast<int>(poses.size());
  std::vector<double> speeds;
  for (int i = 0; i < size; ++i) {
    const int first = std::max(i - kSpeedReach, 0);
    const int last = std::min(i + kSpeedReach, size - 1);
    double way = 0.;
    for (int k = first; k < last; ++k) {
      way += (poses[k + 1].translation() - poses[k].translation()).norm();
    }
    const double seconds = cartographer::common::ToSeconds(times[last] - times[first]);
    speeds.push_back(seconds > 0. ? way / seconds : 0.);
  }
  return speeds;
}

std::vector<double> Distances(const Poses& poses, const Poses& others) {
  CHECK_EQ(poses.size(), others.size());
  std::vector<double> distances;
  for (size_t i = 0; i < poses.size(); ++i) {
    distances.push_back((poses[i].translation() - others[i].translation()).norm());
  }
  return distances;
}

Poses AlignedOnto(const Poses& target, const Poses& poses) {
  CHECK_EQ(target.size(), poses.size());
  CHECK(!poses.empty());
  Rigid3d target_from_world(target.front() * poses.front().inverse());
  if (poses.size() >= 3) {
    const Eigen::Matrix4d motion = Eigen::umeyama(Positions(poses), Positions(target), false);
    target_from_world = Rigid3d(motion.topRightCorner<3, 1>(),
                                Eigen::Quaterniond(motion.topLeftCorner<3, 3>().eval()));
  }
  Poses aligned;
  for (const Rigid3d& pose : poses) aligned.push_back(target_from_world * pose);
  return aligned;
}

}  // namespace semantic_kiss::report
