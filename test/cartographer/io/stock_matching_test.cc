// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "cartographer/io/map_reader.h"
#include "cartographer/io/pose_proto.h"
#include "cartographer/scan_matching/matching_scan.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/scan_matching/submap_matcher.h"
#include "cartographer/transform/rigid_transform.h"
#include "test/testing/shipped_options.h"
#include "test/testing/test_files.h"

// Scans without labels are matched with the submaps of a map that stock Cartographer made of a real
// building: that FromStockGrid() leaves enough to localize by, and in the right place.
namespace cartographer::io {
namespace {

using scan_matching::InPlane;
using scan_matching::MatchingScan;
using scan_matching::PlanarPose;
using scan_matching::ScoreModel;
using scan_matching::SubmapMatcher;
using semantic_kiss_testing::RealDataDirectory;
using semantic_kiss_testing::ShippedOptions;

struct Sample {
  submap::SubmapId submap_id;
  PlanarPose submap_from_node;
  sensor::LabeledPointCloud cloud;  // in the node's level frame
};

// The node of a constraint within a submap, turned level.
Sample SampleOf(const map::Constraint& constraint, const map::Map& map) {
  const map::MapNode& node = map.nodes.at(constraint.node_id);
  const transform::Rigid3d level_from_node =
      transform::Level(node.local_from_node).inverse() * node.local_from_node;
  Sample sample{constraint.submap_id,
                InPlane(constraint.submap_from_node * level_from_node.inverse()), *node.cloud};
  for (Eigen::Vector3f& point : sample.cloud.positions) {
    point = (level_from_node * point.cast<double>()).cast<float>();
  }
  return sample;
}

class StockMatchingTest : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::optional<std::string> data = RealDataDirectory();
    if (!data.has_value()) GTEST_SKIP() << "no maps of stock Cartographer";
    absl::StatusOr<map::Map> map = ReadMap(*data + "/pbstream/stock_aces.pbstream");
    ASSERT_TRUE(map.ok()) << map.status();
    map_ = *std::move(map);
  }

  // Every `step`th of the nodes within submaps, all submaps among them.
  std::vector<Sample> Samples(size_t step) const {
    std::vector<Sample> samples;
    for (size_t i = 0; i < map_.constraints.size(); i += step) {
      if (map_.constraints[i].kind != map::Constraint::Kind::kIntraSubmap) continue;
      samples.push_back(SampleOf(map_.constraints[i], map_));
    }
    return samples;
  }

  map::Map map_;
};

// The lattice of the search and the grid's change of axes cost a cell, the noise of the clouds,
// which Cartographer matched with a map that was still growing, another one.
TEST_P(StockMatchingTest, NodesAreFoundWhereCartographerPutThem) {
  auto options =
      ShippedOptions<scan_matching::proto::ScanMatchingOptions>("scan_matching", "SCAN_MATCHING");
  options.mutable_score()->set_score(GetParam());
  const auto model = ScoreModel::Create(options.score(), map_.labels);
  ASSERT_TRUE(model.ok()) << model.status();
  std::map<submap::SubmapId, SubmapMatcher> matchers;
  for (const auto& [id, submap] : map_.submaps) {
    matchers.emplace(id, SubmapMatcher(submap.submap->grid, *model));
  }
  constexpr int kSeed = 4;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> metres(-3., 3.), turn(-M_PI / 9., M_PI / 9.);
  const std::vector<Sample> samples = Samples(43);
  ASSERT_GT(samples.size(), 100u);
  size_t num_near = 0;
  Eigen::Vector2d sum_of_errors(0., 0.);
  for (const Sample& sample : samples) {
    const SubmapMatcher& matcher = matchers.at(sample.submap_id);
    const PlanarPose& truth = sample.submap_from_node;
    const MatchingScan scan(sample.cloud, *model);
    const PlanarPose guess{truth.translation + Eigen::Vector2d(metres(random), metres(random)),
                           truth.yaw_rad + turn(random)};
    const auto match = matcher.MatchInWindow(scan, guess, {3.2, M_PI / 8.}, 0.2);
    ASSERT_TRUE(match.has_value()) << Name(sample.submap_id);
    const Eigen::Vector2d error = match->submap_from_node.translation - truth.translation;
    const double yaw_error =
        std::remainder(match->submap_from_node.yaw_rad - truth.yaw_rad, 2. * M_PI);
    if (error.norm() > 2. * matcher.resolution_m() || std::abs(yaw_error) > 0.03) continue;
    ++num_near;
    sum_of_errors += error;
  }
  EXPECT_GE(num_near, 0.9 * samples.size()) << "seed " << kSeed;
  // A grid half a cell off would show here.
  EXPECT_LT((sum_of_errors / num_near).norm(), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Scores, StockMatchingTest,
                         ::testing::Values("occupancy", "dominant_label", "max_layer"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace cartographer::io
