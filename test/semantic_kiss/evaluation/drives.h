// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_SEMANTIC_KISS_EVALUATION_DRIVES_H_
#define TEST_SEMANTIC_KISS_EVALUATION_DRIVES_H_

#include <random>
#include <vector>

#include "cartographer/transform/rigid_transform.h"
#include "cartographer/transform/se3.h"

// Trajectories made for the tests of this folder.
namespace semantic_kiss::evaluation {

using Poses = std::vector<cartographer::transform::Rigid3d>;

// Along x in steps of `step_m`, without turning.
inline Poses StraightDrive(int num_poses, double step_m) {
  Poses poses;
  for (int i = 0; i < num_poses; ++i) {
    poses.push_back(cartographer::transform::Rigid3d::Translation({i * step_m, 0., 0.}));
  }
  return poses;
}

inline cartographer::transform::Rigid3d RandomMotion(std::mt19937* random, double scale_m,
                                                     double scale_rad) {
  std::uniform_real_distribution<double> uniform(-1., 1.);
  cartographer::transform::Twist twist;
  for (int i = 0; i < 6; ++i) twist[i] = (i < 3 ? scale_m : scale_rad) * uniform(*random);
  return cartographer::transform::Exp(twist);
}

// About 1 m a pose along the body's x, swaying in all directions.
inline Poses RandomDrive(int num_poses, std::mt19937* random) {
  const auto forward = cartographer::transform::Rigid3d::Translation({1., 0., 0.});
  Poses poses = {RandomMotion(random, 5., 1.)};
  while (static_cast<int>(poses.size()) < num_poses) {
    poses.push_back(poses.back() * forward * RandomMotion(random, 0.2, 0.1));
  }
  return poses;
}

// The same drive as an odometry that errs a little in every step would tell it.
inline Poses WithDrift(const Poses& poses, std::mt19937* random) {
  Poses drifted = {poses.front()};
  for (size_t i = 1; i < poses.size(); ++i) {
    drifted.push_back(drifted.back() * poses[i - 1].inverse() * poses[i] *
                      RandomMotion(random, 0.02, 0.001));
  }
  return drifted;
}

// The same drive in another world.
inline Poses Moved(const cartographer::transform::Rigid3d& motion, const Poses& poses) {
  Poses moved;
  for (const auto& pose : poses) moved.push_back(motion * pose);
  return moved;
}

// The same path with its positions multiplied.
inline Poses Scaled(const Poses& poses, double scale) {
  Poses scaled;
  for (const auto& pose : poses) scaled.emplace_back(scale * pose.translation(), pose.rotation());
  return scaled;
}

}  // namespace semantic_kiss::evaluation

#endif  // TEST_SEMANTIC_KISS_EVALUATION_DRIVES_H_
