// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/primitive_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kReach = 80.;

std::vector<Primitive> RandomPrimitives(int size, Random* random) {
  std::vector<Primitive> primitives(size);
  for (Primitive& primitive : primitives) {
    primitive.shape = static_cast<Shape>(random->Index(3));
    primitive.centre << random->Uniform(-40., 40.), random->Uniform(-40., 40.),
        random->Uniform(-2., 6.);
    primitive.SetYaw(random->Uniform(-4., 4.));
    primitive.half << random->Uniform(0.05, 6.), random->Uniform(0.05, 3.),
        random->Uniform(0.1, 3.);
    if (primitive.shape == Shape::kCylinder) primitive.half.y() = primitive.half.x();
  }
  return primitives;
}

Ray RandomRay(Random* random) {
  Ray ray;
  ray.origin << random->Uniform(-60., 60.), random->Uniform(-60., 60.), random->Uniform(-3., 8.);
  ray.direction << random->Normal(), random->Normal(), 0.3 * random->Normal();
  ray.direction.normalize();
  return ray;
}

double NearestByGrid(const PrimitiveGrid& grid, const std::vector<Primitive>& primitives,
                     const Ray& ray) {
  double nearest = kReach;
  grid.Walk(ray, kReach, [&](uint32_t index, double limit) {
    const auto stretch = Intersect(primitives[index], ray);
    if (stretch && stretch->near > 0.) nearest = std::min(nearest, stretch->near);
    return std::min(limit, nearest);
  });
  return nearest;
}

TEST(PrimitiveGridTest, FindsWhatLookingAtAllFinds) {
  Random random(5, Purpose::kRay);
  const std::vector<Primitive> primitives = RandomPrimitives(150, &random);
  const PrimitiveGrid grid(primitives);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Ray ray = RandomRay(&random);
    double nearest = kReach;
    for (const Primitive& primitive : primitives) {
      const auto stretch = Intersect(primitive, ray);
      if (stretch && stretch->near > 0.) nearest = std::min(nearest, stretch->near);
    }
    EXPECT_EQ(NearestByGrid(grid, primitives, ray), nearest) << i;
    hits += nearest < kReach;
  }
  EXPECT_GT(hits, 1000);
}

TEST(PrimitiveGridTest, EmptyWorldAndAxisParallelRays) {
  const PrimitiveGrid empty({});
  Random random(6, Purpose::kRay);
  EXPECT_EQ(NearestByGrid(empty, {}, RandomRay(&random)), kReach);

  std::vector<Primitive> one(1);
  one[0].centre << 10., 0., 0.;
  const PrimitiveGrid grid(one);
  EXPECT_EQ(NearestByGrid(grid, one, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}), 9.5);
  EXPECT_EQ(NearestByGrid(grid, one, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()}), kReach);
  EXPECT_EQ(NearestByGrid(grid, one, {Eigen::Vector3d(10., 0., 9.), -Eigen::Vector3d::UnitZ()}),
            8.5);
}

}  // namespace
}  // namespace semantic_kiss::simulation
