// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/hit.h"

#include <gtest/gtest.h>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

TEST(HitTest, LeavesStopRaysAtDepthsThatDoNotRepeat) {
  Primitive cloud;
  cloud.shape = Shape::kEllipsoid;
  cloud.texture = Texture::kCloud;
  cloud.half = Eigen::Vector3d::Constant(5.);
  cloud.density = 2.f;
  const Ray ray{Eigen::Vector3d(-10., 0., 0.), Eigen::Vector3d::UnitX()};
  const auto stretch = Intersect(cloud, ray);
  ASSERT_TRUE(stretch);
  double sum = 0.;
  int stopped = 0;
  for (uint64_t key = 0; key < 10000; ++key) {
    const auto t = StopIn(cloud, *stretch, Scramble(key));
    ASSERT_EQ(t, StopIn(cloud, *stretch, Scramble(key)));
    if (!t) continue;
    EXPECT_GE(*t, 5.);
    EXPECT_LE(*t, 15.);
    sum += *t - 5.;
    ++stopped;
  }
  EXPECT_GT(stopped, 9990);
  EXPECT_NEAR(sum / stopped, 0.5, 0.02);  // mean free path: 1 / density
}

TEST(HitTest, FencesStopTheirShareOfRays) {
  Primitive fence;
  fence.texture = Texture::kPorous;
  fence.density = 0.3f;
  const Stretch stretch{1., 2., Eigen::Vector3d::UnitX()};
  int stopped = 0;
  for (uint64_t key = 0; key < 10000; ++key)
    stopped += StopIn(fence, stretch, Scramble(key)).has_value();
  EXPECT_NEAR(stopped / 10000., 0.3, 0.02);
}

}  // namespace
}  // namespace semantic_kiss::simulation
