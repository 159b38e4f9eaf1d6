// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/scanner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "cartographer/transform/se3.h"
#include "semantic_kiss/simulation/facade.h"
#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

using cartographer::transform::Exp;
using cartographer::transform::Log;
using cartographer::transform::Rigid3d;

// How far a static point is from the surface that it claims to have hit [m], the niches and swells
// of facades allowed for.
double DistanceToClaim(const World& world, const SimulatedPoint& point) {
  const Eigen::Vector3d position = point.true_position.cast<double>();
  if (point.primitive < 0) {
    return std::abs(position.z() - world.ground().Height(position.head<2>()));
  }
  const Primitive& primitive = world.primitives()[point.primitive];
  const double allowed_m = primitive.texture == Texture::kFacade ? kDeepestNiche_m + 3. * 0.03 : 0.;
  return std::max(0., DistanceToSurface(primitive, position) - allowed_m);
}

TEST(ScannerTest, EveryReturnLiesOnTheSurfaceItClaims) {
  const auto drive = SmallDrive();
  std::set<uint16_t> labels;
  int points = 0;
  for (int scan = 0; scan < drive->num_scans(); scan += 10) {
    for (const SimulatedPoint& point : drive->Scan(scan)) {
      if (point.moving) continue;
      ++points;
      labels.insert(point.label);
      // A hair's breadth: positions are rounded to float, the ground is found by bisection.
      EXPECT_LT(DistanceToClaim(drive->world(), point), 0.02) << "label " << point.label;
    }
  }
  EXPECT_GT(points, 10000);
  EXPECT_GT(labels.size(), 6u);
}

TEST(ScannerTest, WithoutErrorsWrittenPointsAreTheTrueOnes) {
  const auto drive = SmallDrive(kNoErrors);
  for (const int scan : {0, 7, 30}) {
    const Rigid3d world_from_lidar = drive->world_from_lidar()[scan];
    for (const SimulatedPoint& point : drive->Scan(scan)) {
      const Eigen::Vector3d position = world_from_lidar * point.position.cast<double>();
      EXPECT_NEAR((position - point.true_position.cast<double>()).norm(), 0., 1e-3);
    }
  }
}

TEST(ScannerTest, WithErrorsWrittenPointsAreNearTheTrueOnes) {
  const auto drive = SmallDrive("options.errors.vertical_angle_deg = 0.");
  double squares = 0.;
  int points = 0;
  for (const int scan : {5, 20}) {
    const Rigid3d world_from_lidar = drive->world_from_lidar()[scan];
    for (const SimulatedPoint& point : drive->Scan(scan)) {
      const Eigen::Vector3d position = world_from_lidar * point.position.cast<double>();
      const double error_m = (position - point.true_position.cast<double>()).norm();
      EXPECT_LT(error_m, 0.2 + 0.02 * point.position.norm());
      squares += error_m * error_m;
      ++points;
    }
  }
  EXPECT_GT(std::sqrt(squares / points), 0.01);
  EXPECT_LT(std::sqrt(squares / points), 0.2);
}

TEST(ScannerTest, LabelsAreThoseOfTheSurface) {
  const auto drive = SmallDrive();
  for (const SimulatedPoint& point : drive->Scan(25)) {
    if (point.moving) {
      EXPECT_GE(point.label, label::kMovingCar);
    } else if (point.primitive >= 0) {
      const Primitive& primitive = drive->world().primitives()[point.primitive];
      EXPECT_EQ(point.label, primitive.material.label);
      EXPECT_EQ(point.object, primitive.object);
    } else {
      const Eigen::Vector2d place = point.true_position.head<2>().cast<double>();
      // Float positions may fall on the other side of a border.
      const Eigen::Vector2d aside(1e-3, 1e-3);
      const std::set<uint16_t> near = {drive->world().ground().MaterialAt(place).label,
                                       drive->world().ground().MaterialAt(place + aside).label,
                                       drive->world().ground().MaterialAt(place - aside).label};
      EXPECT_EQ(near.count(point.label), 1u);
    }
  }
}

TEST(ScannerTest, RawPointsAreAsMeasuredWithTheirTimes) {
  const auto raw = SmallDrive(std::string(kNoErrors) + "options.raw = true");
  const int scan = 30;
  const auto& poses = raw->world_from_lidar();
  const auto motion = Log(poses[scan - 1].inverse() * poses[scan]);
  ASSERT_GT(motion.norm(), 0.3) << "the car stands";
  float earliest = 0.f, latest = -1.f;
  for (const SimulatedPoint& point : raw->Scan(scan)) {
    EXPECT_GE(point.time_s, -0.1f);
    EXPECT_LE(point.time_s, 0.f);
    earliest = std::min(earliest, point.time_s);
    latest = std::max(latest, point.time_s);
    const Rigid3d world_from_sensor = poses[scan] * Exp(10. * point.time_s * motion);
    const Eigen::Vector3d position = world_from_sensor * point.position.cast<double>();
    EXPECT_NEAR((position - point.true_position.cast<double>()).norm(), 0., 2e-3);
  }
  EXPECT_LT(earliest, -0.098f);
  EXPECT_GT(latest, -0.002f);
}

TEST(ScannerTest, TheVerticalErrorLowersPointsAsKittisDoes) {
  const auto exact = SmallDrive(kNoErrors);
  const auto lowered =
      SmallDrive(std::string(kNoErrors) + "options.errors.vertical_angle_deg = 0.205");
  const SimulatedScan a = exact->Scan(12), b = lowered->Scan(12);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    // The correction that readers apply: about the axis point x z, upward.
    const Eigen::Vector3d point = b[i].position.cast<double>();
    const Eigen::Vector3d axis = point.cross(Eigen::Vector3d::UnitZ()).normalized();
    const Eigen::Vector3d corrected = Eigen::AngleAxisd(0.205 * M_PI / 180., axis) * point;
    EXPECT_NEAR((corrected - a[i].position.cast<double>()).norm(), 0., 1e-4);
  }
}

using PointKey = std::pair<int, int>;

std::map<PointKey, SimulatedPoint> ByBeam(const SimulatedScan& scan) {
  std::map<PointKey, SimulatedPoint> points;
  for (const SimulatedPoint& point : scan) points.insert({{point.beam, point.column}, point});
  return points;
}

TEST(ScannerTest, AnotherDayLeavesStaticReturnsBitwiseEqual) {
  const auto first = SmallDrive();
  const auto next = SmallDrive("options.epoch = 1");
  int equal = 0, movable = 0;
  for (const int scan : {3, 30, 50}) {
    const auto a = ByBeam(first->Scan(scan)), b = ByBeam(next->Scan(scan));
    for (const auto& [key, point] : a) {
      const auto other = b.find(key);
      if (other == b.end() || IsMovable(point.label) || IsMovable(other->second.label)) {
        ++movable;
        continue;
      }
      ++equal;
      EXPECT_EQ(point.position, other->second.position);
      EXPECT_EQ(point.remission, other->second.remission);
      EXPECT_EQ(point.label, other->second.label);
    }
  }
  EXPECT_GT(equal, 3000);
  EXPECT_GT(movable, 0);
}

TEST(ScannerTest, WithNothingMovableAllDaysAreEqual) {
  const auto first = SmallDrive(kNothingMovable);
  const auto next = SmallDrive(std::string(kNothingMovable) + "options.epoch = 5");
  const SimulatedScan a = first->Scan(20), b = next->Scan(20);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position);
}

TEST(ScannerTest, VisitsOverlap) {
  // Two rounds of a short ring; scans of the second round are laid over the first one's.
  const auto drive = SmallDrive(std::string(kNoErrors) + kNothingMovable +
                                "options.route.kind = 'loop' options.route.ring_m = 160.\n"
                                "options.route.length_m = 400.\n");
  const auto& poses = drive->world_from_lidar();
  int later = -1;
  for (int i = 100; i < drive->num_scans() && later < 0; ++i) {
    if ((poses[i].translation() - poses[10].translation()).norm() < 0.5) later = i;
  }
  ASSERT_GT(later, 0) << "the loop does not close";
  std::set<std::tuple<int, int, int>> seen;
  const auto cell = [](const Eigen::Vector3d& p, int dx, int dy, int dz) {
    constexpr double kCell_m = 0.4;
    return std::make_tuple(static_cast<int>(std::floor(p.x() / kCell_m)) + dx,
                           static_cast<int>(std::floor(p.y() / kCell_m)) + dy,
                           static_cast<int>(std::floor(p.z() / kCell_m)) + dz);
  };
  for (int scan = 5; scan < 16; ++scan) {
    for (const SimulatedPoint& point : drive->Scan(scan)) {
      const Eigen::Vector3d p = poses[scan] * point.position.cast<double>();
      for (int n = 0; n < 27; ++n) seen.insert(cell(p, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
    }
  }
  int found = 0, total = 0;
  for (const SimulatedPoint& point : drive->Scan(later)) {
    if (point.label == label::kVegetation || point.position.norm() > 12.f) continue;
    found += seen.count(cell(poses[later] * point.position.cast<double>(), 0, 0, 0)) > 0;
    ++total;
  }
  ASSERT_GT(total, 500);
  EXPECT_GT(static_cast<double>(found) / total, 0.95);
}

}  // namespace
}  // namespace semantic_kiss::simulation
