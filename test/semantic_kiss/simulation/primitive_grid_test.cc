// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/primitive_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

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

Wedge RandomWedge(Random* random) {
  Wedge wedge;
  wedge.tip << random->Uniform(-60., 60.), random->Uniform(-60., 60.);
  const double azimuth = random->Uniform(0., 2. * M_PI);
  wedge.heading << std::cos(azimuth), std::sin(azimuth);
  wedge.right = random->Uniform(-0.3, 0.2);
  wedge.left = wedge.right + random->Uniform(0., 0.1);
  wedge.reach_m = random->Uniform(5., 80.);
  return wedge;
}

// Points of a primitive seen from above that lie in the wedge, sought at random.
bool SeenIn(const Wedge& wedge, const Primitive& primitive, Random* random) {
  for (int i = 0; i < 300; ++i) {
    const double turn = random->Uniform(0., 2. * M_PI);
    Eigen::Vector3d local(std::cos(turn) * primitive.half.x(), std::sin(turn) * primitive.half.y(),
                          0.);
    if (primitive.shape == Shape::kBox) {
      local << random->Uniform(-1., 1.) * primitive.half.x(),
          random->Uniform(-1., 1.) * primitive.half.y(), 0.;
    }
    const Eigen::Vector2d offset =
        (primitive.centre + primitive.FromLocal(local)).head<2>() - wedge.tip;
    const double ahead = wedge.heading.dot(offset);
    const double aside = wedge.heading.x() * offset.y() - wedge.heading.y() * offset.x();
    if (ahead > 0. && ahead < wedge.reach_m && aside < wedge.left * ahead &&
        aside > wedge.right * ahead) {
      return true;
    }
  }
  return false;
}

TEST(PrimitiveGridTest, FindsWhatIsSeenInWedges) {
  Random random(5, Purpose::kRay);
  const std::vector<Primitive> primitives = RandomPrimitives(100, &random);
  const PrimitiveGrid grid(primitives);
  int seen = 0, visits = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Wedge wedge = RandomWedge(&random);
    std::set<uint32_t> visited;
    grid.ForEachIn(wedge, [&](uint32_t index) { visited.insert(index); });
    visits += static_cast<int>(visited.size());
    for (uint32_t i = 0; i < primitives.size(); ++i) {
      if (!SeenIn(wedge, primitives[i], &random)) continue;
      ++seen;
      EXPECT_EQ(visited.count(i), 1u) << "trial " << trial << ", primitive " << i;
    }
  }
  EXPECT_GT(seen, 300);
  // Not all of them always.
  EXPECT_LT(visits, kTrials * 50);
}

TEST(PrimitiveGridTest, FindsWhatIsAround) {
  Random random(6, Purpose::kRay);
  const std::vector<Primitive> primitives = RandomPrimitives(100, &random);
  const PrimitiveGrid grid(primitives);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector2d point(random.Uniform(-60., 60.), random.Uniform(-60., 60.));
    std::set<uint32_t> visited;
    grid.ForEachAround(point, 10., [&](uint32_t index) { visited.insert(index); });
    for (uint32_t i = 0; i < primitives.size(); ++i) {
      if ((primitives[i].centre.head<2>() - point).norm() < 10.) {
        EXPECT_EQ(visited.count(i), 1u) << i;
      }
    }
  }
}

TEST(PrimitiveGridTest, EmptyWorldsAndWedgesAlongTheAxes) {
  const auto count = [](const PrimitiveGrid& grid, const Wedge& wedge) {
    int visits = 0;
    grid.ForEachIn(wedge, [&](uint32_t) { ++visits; });
    return visits;
  };
  Wedge ahead;
  ahead.reach_m = 20.;
  EXPECT_EQ(count(PrimitiveGrid({}), ahead), 0);

  std::vector<Primitive> one(1);
  one[0].centre << 10., 0., 0.;
  const PrimitiveGrid grid(one);
  EXPECT_GT(count(grid, ahead), 0);
  Wedge behind = ahead;
  behind.heading = -Eigen::Vector2d::UnitX();
  EXPECT_EQ(count(grid, behind), 0);
  Wedge aside = ahead;
  aside.heading = Eigen::Vector2d::UnitY();
  EXPECT_EQ(count(grid, aside), 0);
  Wedge above = aside;
  above.tip << 10., 0.;
  EXPECT_GT(count(grid, above), 0);
}

}  // namespace
}  // namespace semantic_kiss::simulation
