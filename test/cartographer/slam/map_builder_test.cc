// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/map_builder.h"

#include <gtest/gtest.h>

#include "glog/logging.h"
#include "test/testing/shipped_options.h"

namespace cartographer::slam {
namespace {

using submap::NodeId;
using submap::SubmapId;
using transform::Rigid3d;

// Drives 1 m a scan; every second scan is a node, all nodes go into submap 0, later ones into
// submap 1 too.
class ScriptedBuilder : public LocalTrajectoryBuilder {
 public:
  LocalResult AddScan(const sensor::LabeledScan& scan) override {
    LocalResult result;
    result.time = scan.time;
    result.local_from_sensor = Rigid3d::Translation({1. * scan.index, 0., 0.});
    result.outcome = "scripted";
    if (scan.index % 2 == 0) {
      result.insertion.emplace();
      result.insertion->cloud = std::make_shared<const sensor::LabeledPointCloud>();
      result.insertion->submaps[0] = submaps_[0];
      if (scan.index >= 4) {
        submaps_[1]->local_from_submap = Rigid3d::Translation({4., 0., 0.});
        result.insertion->submaps[1] = submaps_[1];
      }
    }
    return result;
  }
  void Finish() override {
    for (auto& submap : submaps_) submap->finished = true;
  }

 private:
  std::vector<std::shared_ptr<submap::Submap>> submaps_ = {std::make_shared<submap::Submap>(0.2),
                                                           std::make_shared<submap::Submap>(0.2)};
};

sensor::LabeledScan Scan(int index) {
  sensor::LabeledScan scan;
  scan.index = index;
  scan.time = common::FromUnixSeconds(0.1 * index);
  return scan;
}

// Without loop closure.
std::unique_ptr<pose_graph::PoseGraph> IdlePoseGraph() {
  auto pose_graph = pose_graph::PoseGraph::Create(
      semantic_kiss_testing::ShippedOptions<pose_graph::proto::PoseGraphOptions>(
          "pose_graph", "POSE_GRAPH", "POSE_GRAPH.optimize_every_n_nodes = 0"),
      sensor::LabelSet());
  CHECK(pose_graph.ok()) << pose_graph.status();
  return *std::move(pose_graph);
}

MapBuilder ScriptedMapBuilder() {
  return MapBuilder(std::make_unique<ScriptedBuilder>(), IdlePoseGraph(), sensor::LabelSet());
}

TEST(MapBuilderTest, FilesNodesSubmapsAndConstraints) {
  MapBuilder builder = ScriptedMapBuilder();
  for (int i = 0; i < 7; ++i) EXPECT_EQ(builder.AddScan(Scan(i)).outcome, "scripted");
  std::vector<common::StageTime> stage_times;
  const map::Map map = builder.Finish(&stage_times);
  ASSERT_EQ(map.nodes.size(), 4);
  ASSERT_EQ(map.submaps.size(), 2);
  ASSERT_EQ(map.constraints.size(), 4 + 2);
  for (const map::Constraint& constraint : map.constraints) {
    const Rigid3d map_from_node =
        map.submaps.at(constraint.submap_id).map_from_submap * constraint.submap_from_node;
    EXPECT_LT(
        (map_from_node.Matrix() - map.nodes.at(constraint.node_id).map_from_node.Matrix()).norm(),
        1e-12);
    EXPECT_EQ(constraint.kind, map::Constraint::Kind::kIntraSubmap);
  }
  EXPECT_TRUE(map.submaps.at(SubmapId{0, 1}).submap->finished);
}

TEST(MapBuilderTest, ScansBetweenNodesFollowTheirNode) {
  MapBuilder builder = ScriptedMapBuilder();
  for (int i = 0; i < 4; ++i) builder.AddScan(Scan(i));
  std::vector<common::StageTime> stage_times;
  map::Map map = builder.Finish(&stage_times);
  // Whatever moves a node moves the scans after it.
  map.nodes.at(NodeId{0, 1}).map_from_node = Rigid3d::Translation({2., 10., 0.});
  const std::vector<Rigid3d> poses = PlaceScans(map, builder.scan_poses());
  ASSERT_EQ(poses.size(), 4);
  EXPECT_LT((poses[1].translation() - Eigen::Vector3d(1., 0., 0.)).norm(), 1e-12);
  EXPECT_LT((poses[3].translation() - Eigen::Vector3d(3., 10., 0.)).norm(), 1e-12);
}

TEST(MapBuilderTest, TracesTheScansThatItIsToldTo) {
  MapBuilder builder = ScriptedMapBuilder();
  ScanTrace trace;
  builder.AddScan(Scan(0));
  builder.TraceTo(&trace);
  builder.AddScan(Scan(1));  // no node: nothing for the pose graph
  EXPECT_TRUE(trace.empty());
  builder.AddScan(Scan(2));
  ASSERT_EQ(trace.size(), 1u);
  EXPECT_EQ(trace[0].stage, "pose graph");
  EXPECT_EQ(trace[0].outcome, "node 1 of trajectory 0 at x 2.00, y 0.00, z 0.00 m, yaw 0.0 deg");
  builder.TraceTo(nullptr);
  builder.AddScan(Scan(4));
  EXPECT_EQ(trace.size(), 1u);
}

TEST(MapBuilderDeathTest, TimeMustNotStandStill) {
  MapBuilder builder = ScriptedMapBuilder();
  builder.AddScan(Scan(0));
  EXPECT_DEATH(builder.AddScan(Scan(0)), "time");
}

}  // namespace
}  // namespace cartographer::slam
