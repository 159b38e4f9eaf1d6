// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/cartographer/pose_graph/street_scene.h"

#include <random>

#include "glog/logging.h"
#include "test/cartographer/scan_matching/small_scenes.h"
#include "test/testing/shipped_options.h"

namespace cartographer::pose_graph {
namespace {

constexpr double kSlope = 0.02;
constexpr double kHalfLength_m = 50.;

enum SmallLabel { kCar = 1, kRoad = 2, kSidewalk = 3, kBuilding = 4, kVegetation = 5, kPole = 6 };

double GroundAt(double x) { return kSlope * x; }

class Builder {
 public:
  // An upright rectangle from (x0, y0) to (x1, y1), standing on the ground.
  void Wall(double x0, double y0, double x1, double y1, double height, int label) {
    const Eigen::Vector2d from(x0, y0), to(x1, y1);
    const int along = static_cast<int>((to - from).norm() / kSpacing_m) + 1;
    const int up = static_cast<int>(height / kSpacing_m);
    for (int i = 0; i <= along; ++i) {
      const Eigen::Vector2d place = from + (to - from) * i / along;
      for (int k = 0; k < up; ++k) {
        points_.push_back({{place.x(), place.y(), GroundAt(place.x()) + k * kSpacing_m}, label});
      }
    }
  }

  void Box(double x, double y, double length, double width, double height, int label) {
    Wall(x, y, x + length, y, height, label);
    Wall(x + length, y, x + length, y + width, height, label);
    Wall(x + length, y + width, x, y + width, height, label);
    Wall(x, y + width, x, y, height, label);
  }

  void Ground() {
    for (double x = -kHalfLength_m; x < kHalfLength_m; x += 2. * kSpacing_m) {
      for (double y = -12.; y < 12.; y += 2. * kSpacing_m) {
        const bool road = std::abs(y) < 5.;
        points_.push_back({{x, y, GroundAt(x) + (road ? 0. : 0.12)}, road ? kRoad : kSidewalk});
      }
    }
  }

  std::vector<ScenePoint> Take() { return std::move(points_); }

 private:
  static constexpr double kSpacing_m = 0.2;
  std::vector<ScenePoint> points_;
};

void AddHouses(double side, std::mt19937* random, Builder* builder) {
  std::uniform_real_distribution<double> length(6., 15.), gap(1., 6.), back(8., 11.);
  for (double x = -kHalfLength_m; x < kHalfLength_m;) {
    const double house = length(*random);
    builder->Box(x, side * back(*random) - (side < 0. ? 4. : 0.), house, 4., 6., kBuilding);
    x += house + gap(*random);
  }
}

void AddPoles(double side, std::mt19937* random, Builder* builder) {
  std::uniform_real_distribution<double> gap(5., 18.);
  for (double x = -kHalfLength_m + gap(*random); x < kHalfLength_m; x += gap(*random)) {
    builder->Box(x, side * 6.2, 0.15, 0.15, 5., kPole);
  }
}

void AddCars(double side, std::mt19937* random, Builder* builder) {
  std::uniform_real_distribution<double> gap(5., 14.);
  for (double x = -kHalfLength_m + gap(*random); x < kHalfLength_m - 5.; x += gap(*random)) {
    builder->Box(x, side * 4. - 0.9, 4.2, 1.8, 1.5, kCar);
  }
}

}  // namespace

std::vector<ScenePoint> MakeStreet(const StreetOptions& options) {
  Builder builder;
  builder.Ground();
  if (!options.landmarks) {
    builder.Wall(-kHalfLength_m, 8., kHalfLength_m, 8., 6., kBuilding);
    builder.Wall(-kHalfLength_m, -8., kHalfLength_m, -8., 6., kBuilding);
    return builder.Take();
  }
  std::mt19937 random(options.seed), cars(options.parked_cars);
  for (const double side : {1., -1.}) {
    AddHouses(side, &random, &builder);
    AddPoles(side, &random, &builder);
    if (options.parked_cars != 0) AddCars(side, &cars, &builder);
  }
  return builder.Take();
}

sensor::LabeledPointCloud SeeFrom(const std::vector<ScenePoint>& street,
                                  const transform::Rigid3d& scene_from_sensor,
                                  const VisitOptions& options) {
  constexpr double kReach_m = 45.;
  std::mt19937 random(options.visit);
  std::bernoulli_distribution seen(options.share), mistaken(options.label_noise);
  std::normal_distribution<double> noise(0., 0.02);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  std::uniform_int_distribution<int> any_label(1, kPole);
  const transform::Rigid3d sensor_from_scene = scene_from_sensor.inverse();
  sensor::LabeledPointCloud cloud;
  for (const ScenePoint& point : street) {
    if (!seen(random)) continue;
    // Visits hit a surface at different points of it.
    const Eigen::Vector3d hit = point.position + Eigen::Vector3d(shift(random), 0., noise(random)) +
                                Eigen::Vector3d(0., noise(random), 0.);
    const Eigen::Vector3d position = sensor_from_scene * hit;
    if (position.norm() > kReach_m) continue;
    const bool wrong = mistaken(random);
    cloud.positions.push_back(position.cast<float>());
    cloud.labels.push_back(scan_matching::LabelAt(wrong ? any_label(random) : point.label));
    cloud.certainties.push_back(wrong ? 0.5f : 0.95f);
  }
  return cloud;
}

proto::VerificationOptions ShippedVerificationOptions(const std::string& overrides) {
  return semantic_kiss_testing::ShippedOptions<proto::VerificationOptions>(
      "closure_verification", "CLOSURE_VERIFICATION", overrides);
}

ClosureTarget TargetOf(const std::vector<ScenePoint>& street,
                       const proto::VerificationOptions& options) {
  const sensor::LabeledPointCloud cloud =
      SeeFrom(street, transform::Rigid3d::Identity(), {/*visit=*/99, /*share=*/0.8});
  return ClosureTarget({{&cloud, transform::Rigid3d::Identity()}}, scan_matching::SmallLabelSet(),
                       options);
}

transform::Rigid3d NodeOnStreet(double x, double y, double yaw_rad) {
  const Eigen::Quaterniond heading(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.01, Eigen::Vector3d(0.8, 0.6, 0.)));
  return transform::Rigid3d({x, y, GroundAt(x) + 1.7}, heading * tilt);
}

}  // namespace cartographer::pose_graph
