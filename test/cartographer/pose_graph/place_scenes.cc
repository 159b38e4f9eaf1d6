// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/cartographer/pose_graph/place_scenes.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <tuple>

#include "absl/strings/str_cat.h"
#include "glog/logging.h"
#include "test/testing/shipped_options.h"

namespace cartographer::pose_graph {
namespace {

std::string ConfigurationFiles() {
  const char* const root = std::getenv("SEMANTIC_KISS_SOURCE_DIR");
  CHECK(root != nullptr);
  return absl::StrCat(root, "/configuration_files");
}

// Draws things of a street by chance.
class StreetMaker {
 public:
  explicit StreetMaker(int seed) : random_(seed), labels_(ShippedLabels()) {}

  double Between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  sensor::Label Labeled(const std::string& name) const { return labels_.FromName(name).value(); }

  void AddPoint(double x, double y, double z, sensor::Label label) {
    cloud.positions.push_back(Eigen::Vector3d(x, y, z).cast<float>());
    cloud.labels.push_back(label);
    cloud.certainties.push_back(1.f);
  }

  // Points on an upright wall, with its foot on the ground.
  void AddWall(double x0, double x1, double y, sensor::Label label) {
    for (int i = 0; i < 60 * (x1 - x0); ++i) AddPoint(Between(x0, x1), y, Between(0., 4.), label);
  }

  // Houses and hedges along a side of the street, trees and poles before them.
  void AddSide(double side) {
    const sensor::Label building = Labeled("building"), hedge = Labeled("vegetation");
    for (double x = -60.; x < 60.;) {
      const double length = Between(8., 25.), setback = side * Between(8., 14.);
      AddWall(x, x + length, setback, Between(0., 1.) < 0.7 ? building : hedge);
      x += length + Between(2., 10.);
    }
    const sensor::Label trunk = Labeled("trunk"), pole = Labeled("pole");
    for (int i = 0; i < 8; ++i) {
      const double x = Between(-60., 60.);
      const sensor::Label label = Between(0., 1.) < 0.5 ? trunk : pole;
      for (int hit = 0; hit < 60; ++hit) AddPoint(x, side * 6.5, Between(0., 4.), label);
    }
  }

  void AddGround() {
    const sensor::Label road = Labeled("road"), sidewalk = Labeled("sidewalk");
    for (int i = 0; i < 12000; ++i) {
      const double x = Between(-60., 60.), y = Between(-14., 14.);
      AddPoint(x, y, 0., std::abs(y) < 4. ? road : sidewalk);
    }
  }

  void AddParkedCars() {
    const sensor::Label car = Labeled("car");
    for (int i = 0; i < 8; ++i) {
      const double x = Between(-60., 56.), y = Between(0., 1.) < 0.5 ? -5. : 5.;
      AddWall(x, x + 4., y, car);
    }
  }

  sensor::LabeledPointCloud cloud;

 private:
  std::mt19937 random_;
  const sensor::LabelSet labels_;
};

}  // namespace

sensor::LabelSet ShippedLabels(const std::string& name) {
  return sensor::LabelSet::Load({absl::StrCat(ConfigurationFiles(), "/labels/", name, ".lua"), {}})
      .value();
}

proto::PlaceRecognitionOptions ShippedPlaceOptions(const std::string& changes) {
  return semantic_kiss_testing::ShippedOptions<proto::PlaceRecognitionOptions>(
      "place_recognition", "PLACE_RECOGNITION", changes);
}

PlaceDescriber ShippedDescriber() {
  return PlaceDescriber::Create(ShippedPlaceOptions(), ShippedLabels()).value();
}

sensor::LabeledPointCloud Street(int seed, int day) {
  StreetMaker street(seed);
  street.AddSide(-1.);
  street.AddSide(1.);
  street.AddGround();
  StreetMaker cars(1000 * day + seed);
  cars.AddParkedCars();
  for (size_t i = 0; i < cars.cloud.size(); ++i) street.cloud.Append(cars.cloud, i);
  return street.cloud;
}

sensor::LabeledPointCloud WithWrongLabels(const sensor::LabeledPointCloud& cloud, double share,
                                          int seed) {
  std::mt19937 random(seed);
  const std::vector<sensor::Label> mistakes(cloud.labels.begin(), cloud.labels.end());
  std::map<std::tuple<int, int>, sensor::Label> of_block;
  sensor::LabeledPointCloud result = cloud;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f block = (cloud.positions[i] / 2.f).array().floor();
    const auto [it, inserted] = of_block.try_emplace(
        {static_cast<int>(block.x()), static_cast<int>(block.y())}, sensor::kUnlabeled);
    if (inserted && std::uniform_real_distribution<double>(0., 1.)(random) < share) {
      it->second = mistakes[random() % mistakes.size()];
    }
    if (it->second != sensor::kUnlabeled) result.labels[i] = it->second;
  }
  return result;
}

}  // namespace cartographer::pose_graph
