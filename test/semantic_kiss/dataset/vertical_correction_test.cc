// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/vertical_correction.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace semantic_kiss::dataset {
namespace {

constexpr double kAngle = 0.205 * M_PI / 180.;

double Elevation(const Eigen::Vector3f& point) {
  const Eigen::Vector3d p = point.cast<double>();
  return std::atan2(p.z(), p.head<2>().norm());
}

double Azimuth(const Eigen::Vector3f& point) {
  return std::atan2(double{point.y()}, double{point.x()});
}

TEST(RaiseElevationTest, RaisesAPointAheadByTheAngle) {
  std::vector<Eigen::Vector3f> points = {{10.f, 0.f, 0.f}};
  RaiseElevation(kAngle, &points);
  EXPECT_NEAR(points[0].x(), 10. * std::cos(kAngle), 1e-6);
  EXPECT_EQ(points[0].y(), 0.f);
  EXPECT_NEAR(points[0].z(), 10. * std::sin(kAngle), 1e-8);  // 3.6 cm
  EXPECT_NEAR(Elevation(points[0]) * 180. / M_PI, 0.205, 1e-7);
}

TEST(RaiseElevationTest, ChangesNothingButTheElevation) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-80.f, 80.f);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 1000; ++i) {
    points.emplace_back(uniform(random), uniform(random), 0.3f * uniform(random));
  }
  const std::vector<Eigen::Vector3f> before = points;
  RaiseElevation(kAngle, &points);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(Elevation(points[i]) - Elevation(before[i]), kAngle, 1e-6) << before[i];
    EXPECT_NEAR(points[i].norm(), before[i].norm(), 2e-5) << before[i];
    EXPECT_NEAR(Azimuth(points[i]), Azimuth(before[i]), 1e-6) << before[i];
  }
}

// The same by matrices: a rotation about the axis point x z.
TEST(RaiseElevationTest, AgreesWithTheRotationAboutPointCrossZ) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> uniform(-50.f, 50.f);
  for (const double angle : {kAngle, -kAngle, 0.08}) {
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3f point(uniform(random), uniform(random), uniform(random));
      const Eigen::Vector3d axis = point.cast<double>().cross(Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d expected =
          Eigen::AngleAxisd(angle, axis.normalized()) * point.cast<double>();
      std::vector<Eigen::Vector3f> points = {point};
      RaiseElevation(angle, &points);
      EXPECT_LT((points[0].cast<double>() - expected).norm(), 2e-5) << point;
    }
  }
}

TEST(RaiseElevationTest, LowersWhatItRaised) {
  std::vector<Eigen::Vector3f> points = {{3.f, -4.f, 1.f}, {-20.f, 1.f, -1.7f}};
  const std::vector<Eigen::Vector3f> before = points;
  RaiseElevation(kAngle, &points);
  RaiseElevation(-kAngle, &points);
  for (size_t i = 0; i < points.size(); ++i) EXPECT_LT((points[i] - before[i]).norm(), 1e-5f);
}

TEST(RaiseElevationTest, LeavesTheAxisAndTheOrigin) {
  std::vector<Eigen::Vector3f> points = {{0.f, 0.f, 0.f}, {0.f, 0.f, -5.f}};
  RaiseElevation(kAngle, &points);
  EXPECT_EQ(points[0], Eigen::Vector3f(0.f, 0.f, 0.f));
  EXPECT_EQ(points[1], Eigen::Vector3f(0.f, 0.f, -5.f));
}

TEST(RaiseElevationTest, SurvivesWhatIsNoPoint) {
  std::vector<Eigen::Vector3f> nothing;
  RaiseElevation(kAngle, &nothing);
  EXPECT_TRUE(nothing.empty());
  std::vector<Eigen::Vector3f> points = {{NAN, 0.f, 0.f}, {0.f, INFINITY, 1.f}, {1.f, 1.f, NAN}};
  RaiseElevation(kAngle, &points);
  for (const Eigen::Vector3f& point : points) EXPECT_FALSE(point.allFinite());
}

}  // namespace
}  // namespace semantic_kiss::dataset
