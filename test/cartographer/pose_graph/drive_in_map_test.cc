// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// The pose graph with a finished map: drives that nothing ties to it at first.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "test/cartographer/pose_graph/street_drive.h"
#include "test/testing/shipped_options.h"

namespace cartographer::pose_graph {
namespace {

using transform::Rigid3d;

constexpr double kDeg = M_PI / 180.;

// Searches with every node, so that what is found is known at once.
proto::PoseGraphOptions Options(const std::string& changes = "") {
  return semantic_kiss_testing::ShippedOptions<proto::PoseGraphOptions>(
      "pose_graph", "POSE_GRAPH", "POSE_GRAPH.optimize_every_n_nodes = 1\n" + changes);
}

std::unique_ptr<PoseGraph> Create(const proto::PoseGraphOptions& options) {
  auto graph = PoseGraph::Create(options, scan_matching::SmallLabelSet());
  CHECK(graph.ok()) << graph.status();
  return *std::move(graph);
}

std::vector<Rigid3d> AlongStreet(double y, double yaw) {
  std::vector<Rigid3d> poses;
  for (int i = -15; i <= 15; ++i) {
    poses.push_back(NodeOnStreet(std::cos(yaw) > 0. ? i : -i, y, yaw));
  }
  return poses;
}

// One drive through the street, as it was, frozen. Its frame is the street's.
Graph MapOfStreet() {
  const auto graph = Create(Options("POSE_GRAPH.optimize_every_n_nodes = 0"));
  const std::vector<Rigid3d> poses = AlongStreet(0., 0.);
  DriveOnStreet({0, poses, poses}, graph.get());
  Graph map = graph->Release();
  map.frozen_trajectories = {0};
  return map;
}

// A visit from the other end, in a local frame that begins with its first node: far from the map's,
// and as tilted as the car stood.
StreetDrive Visitor() {
  StreetDrive drive{1, AlongStreet(2., M_PI), {}};
  drive.first_visit = 1000;
  for (const Rigid3d& pose : drive.truth) {
    drive.local.push_back(drive.truth.front().inverse() * pose);
  }
  return drive;
}

void ExpectInPlace(const PoseGraph& graph, const StreetDrive& drive, double at_most_m) {
  ASSERT_TRUE(graph.IsTied(1));
  for (size_t i = 0; i < drive.truth.size(); ++i) {
    const auto node = graph.graph().nodes.find({1, static_cast<int>(i)});
    if (node == graph.graph().nodes.end()) continue;
    const Rigid3d error = drive.truth[i].inverse() * node->second.map_from_node;
    EXPECT_LT(error.translation().norm(), at_most_m) << i;
    EXPECT_LT(transform::RotationAngle(error), 1. * kDeg) << i;
  }
}

class DriveInMapTest : public ::testing::Test {
 protected:
  DriveInMapTest() : map_(MapOfStreet()), drive_(Visitor()) {}

  std::unique_ptr<PoseGraph> Visit(const std::string& changes) {
    auto graph = Create(Options(changes));
    graph->AddMap(map_);
    DriveOnStreet(drive_, graph.get());
    std::vector<common::StageTime> times;
    graph->Finish(&times);
    return graph;
  }

  const Graph map_;
  const StreetDrive drive_;
};

TEST_F(DriveInMapTest, PlaceRecognitionTiesItAndTheMapStays) {
  const auto graph = Visit("");
  ExpectInPlace(*graph, drive_, 0.15);
  for (const auto& [id, node] : map_.nodes) {
    EXPECT_EQ(graph->graph().nodes.at(id).map_from_node.translation(),
              node.map_from_node.translation());
    EXPECT_EQ(graph->graph().nodes.at(id).map_from_node.rotation().coeffs(),
              node.map_from_node.rotation().coeffs());
  }
}

TEST_F(DriveInMapTest, WithoutAnyProposalItStaysApart) {
  const auto graph = Visit("POSE_GRAPH.candidates.max_places = 0");
  EXPECT_FALSE(graph->IsTied(1));
  EXPECT_TRUE(graph->closures().empty());
}

TEST_F(DriveInMapTest, AllOfTheMapIsSearchedWherePlacesAreNotRecognized) {
  const auto graph = Visit(
      "POSE_GRAPH.candidates.max_places = 0\nPOSE_GRAPH.candidates.search_all.after_nodes = 1");
  ExpectInPlace(*graph, drive_, 0.15);
}

TEST_F(DriveInMapTest, MatchesInThePlaneMayDo) {
  const auto graph = Visit("POSE_GRAPH.verify_in = 'plane'\nPOSE_GRAPH.optimization.dof = 3");
  ASSERT_TRUE(graph->IsTied(1));
  for (size_t i = 0; i < drive_.truth.size(); ++i) {
    const Rigid3d error =
        drive_.truth[i].inverse() * graph->graph().nodes.at({1, static_cast<int>(i)}).map_from_node;
    EXPECT_LT(error.translation().head<2>().norm(), 0.3) << i;
    EXPECT_LT(std::abs(transform::Yaw(error.rotation())), 1. * kDeg) << i;
  }
  // Files then carry the weights of loops, not those of scans within a submap.
  for (const Closure& closure : graph->closures()) {
    EXPECT_TRUE(closure.constraint.information.has_value());
  }
}

TEST_F(DriveInMapTest, AKnownStartNeedsNoPlaceRecognition) {
  auto graph = Create(Options("POSE_GRAPH.candidates.max_places = 0"));
  graph->AddMap(map_);
  // 2 m and 4 degrees off.
  const Rigid3d guess =
      transform::Level(drive_.truth.front()) *
      Rigid3d({1.5, -1.3, 0.},
              Eigen::Quaterniond(Eigen::AngleAxisd(4. * kDeg, Eigen::Vector3d::UnitZ())));
  graph->ExpectNear(1, guess, 400.);
  DriveOnStreet(drive_, graph.get());
  ExpectInPlace(*graph, drive_, 0.15);
}

TEST_F(DriveInMapTest, WhatIsTrimmedIsForgottenAndTheRestGoesOn) {
  const auto graph = Visit("");
  const size_t closures = graph->closures().size();
  graph->TrimBefore({1, 20});
  EXPECT_EQ(graph->graph().nodes.count({1, 19}), 0u);
  EXPECT_LT(graph->closures().size(), closures);
  for (const Closure& closure : graph->closures()) {
    EXPECT_GE(closure.constraint.node_id.node_index, 20);
  }
  ExpectInPlace(*graph, drive_, 0.15);
  graph->RemoveTrajectory(1);
  EXPECT_EQ(graph->graph().nodes.size(), map_.nodes.size());
  EXPECT_TRUE(graph->closures().empty());
  EXPECT_FALSE(graph->IsTied(1));
  // The next one starts from nothing.
  StreetDrive next = drive_;
  next.trajectory_id = 2;
  DriveOnStreet(next, graph.get());
  EXPECT_TRUE(graph->IsTied(2));
}

}  // namespace
}  // namespace cartographer::pose_graph
