// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_POSE_GRAPH_PLACE_SCENES_H_
#define TEST_CARTOGRAPHER_POSE_GRAPH_PLACE_SCENES_H_

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "absl/strings/str_cat.h"
#include "cartographer/common/options_loader.h"
#include "cartographer/pose_graph/place_descriptor.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {

inline std::string ConfigurationFiles() {
  const char* const root = std::getenv("SEMANTIC_KISS_SOURCE_DIR");
  CHECK(root != nullptr);
  return absl::StrCat(root, "/configuration_files");
}

inline sensor::LabelSet KittiLabels() {
  return sensor::LabelSet::Load({ConfigurationFiles() + "/labels/semantic_kitti.lua", {}}).value();
}

// The shipped options, after `changes` in Lua.
inline proto::PlaceRecognitionOptions PlaceOptions(const std::string& changes = "") {
  proto::PlaceRecognitionOptions options;
  const absl::Status status =
      common::LoadOptionsFromString(absl::StrCat("include \"defaults/place_recognition.lua\"\n",
                                                 changes, "\nreturn PLACE_RECOGNITION"),
                                    "test", {ConfigurationFiles()}, &options);
  CHECK(status.ok()) << status;
  return options;
}

inline PlaceDescriber ShippedDescriber() {
  return PlaceDescriber::Create(PlaceOptions(), KittiLabels()).value();
}

// A stretch of street that no other seed has: houses and hedges beside a road, trees and poles.
inline sensor::LabeledPointCloud Street(int seed) {
  const sensor::LabelSet labels = KittiLabels();
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  sensor::LabeledPointCloud cloud;
  const auto add = [&](double x, double y, const std::string& name) {
    cloud.positions.emplace_back(x, y, between(0., 3.));
    cloud.labels.push_back(labels.FromName(name).value());
    cloud.certainties.push_back(1.f);
  };
  for (const double side : {-1., 1.}) {
    for (double x = -60.; x < 60.;) {
      const double length = between(8., 25.), setback = side * between(8., 14.);
      const std::string name = between(0., 1.) < 0.7 ? "building" : "vegetation";
      for (int i = 0; i < 150 * length; ++i) add(between(x, x + length), setback, name);
      x += length + between(2., 10.);
    }
    for (int i = 0; i < 8; ++i) {
      const double x = between(-60., 60.);
      const std::string name = between(0., 1.) < 0.5 ? "trunk" : "pole";
      for (int hit = 0; hit < 40; ++hit) add(x, side * 6.5, name);
    }
  }
  for (int i = 0; i < 20000; ++i) {
    const double y = between(-8., 8.);
    add(between(-60., 60.), y, std::abs(y) < 4. ? "road" : "sidewalk");
  }
  return cloud;
}

inline transform::Rigid3d InPlane(double x, double y, double yaw_rad) {
  return transform::Rigid3d(
      {x, y, 0.}, Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())));
}

}  // namespace cartographer::pose_graph

#endif  // TEST_CARTOGRAPHER_POSE_GRAPH_PLACE_SCENES_H_
