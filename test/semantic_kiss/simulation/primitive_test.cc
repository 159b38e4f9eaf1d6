// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/primitive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

// Whether a point is inside, from the definition of the shape.
bool Inside(const Primitive& primitive, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = primitive.ToLocal(point - primitive.centre);
  if (std::abs(p.z()) > primitive.half.z()) return false;
  const double rise = p.z() + primitive.half.z();
  switch (primitive.shape) {
    case Shape::kBox:
      return p.x() <= primitive.half.x() - primitive.taper[0] * rise &&
             -p.x() <= primitive.half.x() - primitive.taper[1] * rise &&
             p.y() <= primitive.half.y() - primitive.taper[2] * rise &&
             -p.y() <= primitive.half.y() - primitive.taper[3] * rise;
    case Shape::kCylinder:
      return p.head<2>().norm() <= primitive.half.x();
    default:
      return p.cwiseQuotient(primitive.half).norm() <= 1.;
  }
}

Primitive RandomPrimitive(Shape shape, Random* random) {
  Primitive primitive;
  primitive.shape = shape;
  primitive.centre << random->Uniform(-2., 2.), random->Uniform(-2., 2.), random->Uniform(-2., 2.);
  primitive.SetYaw(random->Uniform(-4., 4.));
  primitive.half << random->Uniform(0.3, 2.), random->Uniform(0.3, 2.), random->Uniform(0.3, 2.);
  for (float& taper : primitive.taper) taper = static_cast<float>(random->Uniform(0., 0.5));
  if (shape == Shape::kCylinder) primitive.half.y() = primitive.half.x();
  return primitive;
}

Ray RandomRay(Random* random) {
  Ray ray;
  ray.origin << random->Uniform(-6., 6.), random->Uniform(-6., 6.), random->Uniform(-6., 6.);
  const Eigen::Vector3d target(random->Normal(), random->Normal(), random->Normal());
  ray.direction = (target - ray.origin).normalized();
  return ray;
}

// In the world's frame.
std::optional<Stretch> Meet(const Primitive& primitive, const Ray& ray) {
  std::optional<Stretch> stretch = Intersect(
      primitive,
      {primitive.ToLocal(ray.origin - primitive.centre), primitive.ToLocal(ray.direction)});
  if (stretch) stretch->normal = primitive.FromLocal(stretch->normal);
  return stretch;
}

class PrimitiveTest : public ::testing::TestWithParam<Shape> {};

// The oracle walks along the ray in small steps.
TEST_P(PrimitiveTest, IntersectionAgreesWithWalking) {
  constexpr double kStep = 0.002;
  Random random(11, Purpose::kRay, static_cast<uint64_t>(GetParam()));
  int hits = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Primitive primitive = RandomPrimitive(GetParam(), &random);
    const Ray ray = RandomRay(&random);
    double first = -1., last = -1.;
    for (double t = 0.; t < 16.; t += kStep) {
      if (!Inside(primitive, ray.origin + t * ray.direction)) continue;
      if (first < 0.) first = t;
      last = t;
    }
    const auto stretch = Meet(primitive, ray);
    if (first < 0.) {
      if (stretch) {
        EXPECT_LT(stretch->far - std::max(0., stretch->near), 0.06) << trial;
      }
      continue;
    }
    ++hits;
    ASSERT_TRUE(stretch) << trial;
    EXPECT_NEAR(std::max(0., stretch->near), first, 2. * kStep) << trial;
    EXPECT_NEAR(stretch->far, last, 2. * kStep) << trial;
    if (stretch->near < 0.) continue;
    EXPECT_NEAR(stretch->normal.norm(), 1., 1e-9) << trial;
    EXPECT_LT(stretch->normal.dot(ray.direction), 1e-9) << trial;
    const Eigen::Vector3d entry = ray.origin + stretch->near * ray.direction;
    EXPECT_NEAR(DistanceToSurface(primitive, entry), 0., 1e-6) << trial;
    EXPECT_FALSE(Inside(primitive, entry + 1e-3 * stretch->normal)) << trial;
  }
  EXPECT_GT(hits, 60);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PrimitiveTest,
                         ::testing::Values(Shape::kBox, Shape::kCylinder, Shape::kEllipsoid));

TEST(PrimitiveTest, UprightRayMeetsTheTop) {
  for (const Shape shape : {Shape::kBox, Shape::kCylinder, Shape::kEllipsoid}) {
    Primitive primitive;
    primitive.shape = shape;
    const auto stretch =
        Meet(primitive, {Eigen::Vector3d(0.01, 0.02, 5.), -Eigen::Vector3d::UnitZ()});
    ASSERT_TRUE(stretch);
    EXPECT_NEAR(stretch->near, 4.5, 0.01);
    EXPECT_GT(stretch->normal.z(), 0.9);
  }
}

TEST(PrimitiveTest, NothingBehindTheOrigin) {
  Primitive primitive;
  EXPECT_FALSE(Meet(primitive, {Eigen::Vector3d(3., 0., 0.), Eigen::Vector3d::UnitX()}));
}

TEST(PrimitiveTest, CloudsAreNearFromWithin) {
  Primitive cloud;
  cloud.shape = Shape::kEllipsoid;
  cloud.texture = Texture::kCloud;
  EXPECT_EQ(DistanceToSurface(cloud, Eigen::Vector3d(0.1, 0., 0.)), 0.);
  EXPECT_NEAR(DistanceToSurface(cloud, Eigen::Vector3d(2., 0., 0.)), 1.5, 1e-9);
}

}  // namespace
}  // namespace semantic_kiss::simulation
