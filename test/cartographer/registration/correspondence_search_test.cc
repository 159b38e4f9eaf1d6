// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/registration/correspondence_search.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace cartographer::registration {
namespace {

TEST(CorrespondenceSearchTest, AnswersAreThoseOfTheMapHoweverQueriesMove) {
  constexpr int kSeed = 21;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const auto random_vector = [&](double scale) {
    return Eigen::Vector3d(scale *
                           Eigen::Vector3d(uniform(random), uniform(random), uniform(random)));
  };
  sensor::LabeledPointCloud cloud;
  for (int i = 0; i < 3000; ++i) {
    cloud.positions.push_back(random_vector(5.).cast<float>());
    cloud.labels.push_back(sensor::Label{static_cast<uint8_t>(i % 3)});
    cloud.certainties.push_back(1.f);
  }
  proto::VoxelMapOptions options;
  options.set_voxel_size_m(1.);
  options.set_max_points_per_voxel(20);
  LabeledVoxelMap map(options, {});
  map.Insert(cloud, transform::Rigid3d());

  const auto ask_map = [&](const Eigen::Vector3d& query, sensor::Label label, double gate_m,
                           double agreeing_factor) {
    if (agreeing_factor == 1.) return map.FindNearest(query, gate_m).neighbor;
    auto neighbor = map.FindPreferred(query, label, agreeing_factor).neighbor;
    if (neighbor.has_value() && (neighbor->position - query).norm() >= gate_m) neighbor.reset();
    return neighbor;
  };

  // Gates within and beyond what the 27 voxels are sure to hold; steps from none to large ones.
  for (const auto& [gate_m, agreeing_factor] : std::vector<std::pair<double, double>>{
           {0.2, 1.}, {0.6, 1.}, {3., 1.}, {0.2, 0.05}, {0.6, 0.05}, {3., 0.4}}) {
    std::vector<Eigen::Vector3d> queries(300);
    for (Eigen::Vector3d& query : queries) query = random_vector(6.);
    CorrespondenceSearch search(map, gate_m, agreeing_factor, queries.size());
    int found = 0;
    for (const double step_m : {0., 0.5, 0.1, 0.03, 0.01, 0.001, 0.01, 0.2, 0.0001}) {
      for (size_t i = 0; i < queries.size(); ++i) {
        queries[i] += random_vector(step_m);
        const sensor::Label label{static_cast<uint8_t>(i % 4)};
        const auto remembered = search.Find(i, queries[i], label);
        const auto fresh = ask_map(queries[i], label, gate_m, agreeing_factor);
        ASSERT_EQ(remembered.has_value(), fresh.has_value());
        if (!fresh.has_value()) continue;
        ++found;
        ASSERT_EQ(remembered->position, fresh->position);
      }
    }
    EXPECT_GT(found, 100);
  }
}

}  // namespace
}  // namespace cartographer::registration
