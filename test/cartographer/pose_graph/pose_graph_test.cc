// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/pose_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "cartographer/transform/se3.h"
#include "glog/logging.h"
#include "tbb/task_arena.h"
#include "test/cartographer/pose_graph/street_drive.h"
#include "test/cartographer/scan_matching/small_scenes.h"
#include "test/testing/shipped_options.h"

namespace cartographer::pose_graph {
namespace {

using submap::NodeId;
using transform::Rigid3d;

// As shipped, after `changes` in Lua; rounds are short because the drive is.
proto::PoseGraphOptions Options(const std::string& changes = "") {
  return semantic_kiss_testing::ShippedOptions<proto::PoseGraphOptions>(
      "pose_graph", "POSE_GRAPH", "POSE_GRAPH.optimize_every_n_nodes = 40\n" + changes);
}

// Along the street, a detour on which nothing is seen, and back through the street the other way;
// a node a metre.
std::vector<Rigid3d> TrueDrive() {
  std::vector<Rigid3d> poses;
  for (int x = -15; x <= 15; ++x) poses.push_back(NodeOnStreet(x, 0., 0.));
  for (int i = 1; i < 150; ++i) {
    const double angle = M_PI * i / 150.;
    poses.push_back(NodeOnStreet(15. + 40. * std::sin(angle), 2. * i / 150., angle));
  }
  for (int x = 15; x >= -15; --x) poses.push_back(NodeOnStreet(x, 2., M_PI));
  return poses;
}

bool OnDetour(int node) { return node > 30 && node < 180; }

// What the odometry makes of it: it goes astray on the detour, by metres and degrees.
std::vector<Rigid3d> Drifted(const std::vector<Rigid3d>& truth) {
  transform::Twist drift;
  drift << 0.8, 1.2, 1.5, 0.002, 0.004, 0.03;
  std::vector<Rigid3d> poses;
  for (size_t i = 0; i < truth.size(); ++i) {
    const double astray = std::min(1., std::max(0., (i - 30.) / 150.));
    poses.push_back(transform::Exp(astray * drift) * truth[i]);
  }
  return poses;
}

std::unique_ptr<PoseGraph> Drive(const proto::PoseGraphOptions& options) {
  const sensor::LabelSet labels = scan_matching::SmallLabelSet();
  auto graph = PoseGraph::Create(options, labels);
  CHECK(graph.ok()) << graph.status();
  const std::vector<Rigid3d> truth = TrueDrive();
  std::vector<common::StageTime> times;
  DriveOnStreet({0, truth, Drifted(truth), OnDetour}, graph->get());
  (*graph)->Finish(&times);
  return *std::move(graph);
}

Rigid3d MapFromNode(const PoseGraph& graph, int node) {
  return graph.graph().nodes.at({0, node}).map_from_node;
}

// How wrong the graph is about where the second visit, at the end, was relative to the first.
Rigid3d RevisitError(const PoseGraph& graph) {
  const std::vector<Rigid3d> truth = TrueDrive();
  const Rigid3d first_from_last = MapFromNode(graph, 10).inverse() * MapFromNode(graph, 200);
  return (truth[10].inverse() * truth[200]).inverse() * first_from_last;
}

TEST(PoseGraphTest, ClosesTheLoop) {
  const auto open = Drive(Options("POSE_GRAPH.optimize_every_n_nodes = 0"));
  EXPECT_GT(RevisitError(*open).translation().norm(), 1.9);
  EXPECT_TRUE(open->closures().empty());
  EXPECT_TRUE(open->verdicts().empty());

  const auto closed = Drive(Options());
  EXPECT_LT(RevisitError(*closed).translation().norm(), 0.1);
  EXPECT_LT(transform::RotationAngle(RevisitError(*closed)), 0.4 * M_PI / 180.);
  EXPECT_GE(closed->closures().size(), 5u);
  EXPECT_EQ(closed->verdicts().at("accepted"), closed->closures().size());
  // The largest correction is that of the first closure: all of the drift.
  EXPECT_GT(closed->closures().front().correction_m, 1.5);
  EXPECT_LT(closed->closures().back().correction_m, 0.5);
  EXPECT_GT(closed->closures().front().score, 0.25);
}

TEST(PoseGraphTest, EveryClosureIsRight) {
  const std::vector<Rigid3d> truth = TrueDrive();
  const auto graph = Drive(Options());
  for (const Closure& closure : graph->closures()) {
    const submap::Constraint& constraint = closure.constraint;
    // The submap's frame follows its first node, which is before or after the detour.
    const int first = constraint.submap_id.submap_index * 6;
    const Rigid3d true_from_local = truth[first] * Drifted(truth)[first].inverse();
    const Rigid3d true_submap_from_node =
        (true_from_local *
         graph->graph().submaps.at(constraint.submap_id).submap->local_from_submap)
            .inverse() *
        truth[constraint.node_id.node_index];
    const Rigid3d error = true_submap_from_node.inverse() * constraint.submap_from_node;
    EXPECT_LT(error.translation().norm(), 0.1);
    EXPECT_LT(transform::RotationAngle(error), 0.5 * M_PI / 180.);
    ASSERT_TRUE(constraint.information.has_value());
    EXPECT_EQ(constraint.kind, submap::Constraint::Kind::kInterSubmap);
  }
}

TEST(PoseGraphTest, PlaceRecognitionFindsWhatNoWindowReaches) {
  const auto graph =
      Drive(Options("POSE_GRAPH.candidates.max_nearby = 0\n"
                    "POSE_GRAPH.candidates.place_window_above_m = 0"));
  ASSERT_FALSE(graph->closures().empty());
  for (const Closure& closure : graph->closures()) EXPECT_TRUE(closure.by_place_recognition);
  EXPECT_LT(RevisitError(*graph).translation().norm(), 0.1);
}

TEST(PoseGraphTest, WithoutAgreementNothingIsClosed) {
  const auto graph = Drive(Options("POSE_GRAPH.agreement.min_agreeing = 100"));
  EXPECT_TRUE(graph->closures().empty());
  EXPECT_GT(graph->verdicts().at("no_agreement"), 0);
  EXPECT_GT(RevisitError(*graph).translation().norm(), 1.9);
}

TEST(PoseGraphTest, RemembersWhatCameOfEverySearch) {
  for (const char* changes : {"", "POSE_GRAPH.agreement.min_agreeing = 100"}) {
    const auto graph = Drive(Options(changes));
    int candidates = 0, accepted = 0, verdicts = 0;
    for (const auto& [id, search] : graph->searches()) {
      EXPECT_EQ(graph->graph().nodes.count(id), 1u);
      EXPECT_LE(search.num_accepted, search.num_candidates);
      candidates += search.num_candidates;
      accepted += search.num_accepted;
      if (search.best_rejected.has_value()) {
        EXPECT_EQ(search.best_rejected->closure.constraint.node_id, id);
        EXPECT_GT(graph->verdicts().at(search.best_rejected->verdict), 0);
      }
    }
    for (const auto& [verdict, count] : graph->verdicts()) verdicts += count;
    EXPECT_GT(candidates, 0);
    EXPECT_EQ(candidates, verdicts);
    EXPECT_EQ(accepted, graph->closures().size());
  }
}

TEST(PoseGraphTest, ThreadsChangeNothing) {
  std::vector<std::unique_ptr<PoseGraph>> graphs;
  for (const int threads : {1, 8}) {
    tbb::task_arena arena(threads);
    arena.execute([&] { graphs.push_back(Drive(Options())); });
  }
  ASSERT_EQ(graphs[0]->closures().size(), graphs[1]->closures().size());
  for (const auto& [id, node] : graphs[0]->graph().nodes) {
    const Rigid3d& other = graphs[1]->graph().nodes.at(id).map_from_node;
    EXPECT_EQ(node.map_from_node.translation(), other.translation());
    EXPECT_EQ(node.map_from_node.rotation().coeffs(), other.rotation().coeffs());
  }
}

TEST(PoseGraphTest, AnEmptyDriveIsNone) {
  auto graph = PoseGraph::Create(Options(), scan_matching::SmallLabelSet());
  std::vector<common::StageTime> times;
  (*graph)->Finish(&times);
  EXPECT_TRUE((*graph)->graph().nodes.empty());
}

TEST(PoseGraphTest, ErrorsNameTheOption) {
  proto::PoseGraphOptions options = Options();
  options.mutable_scan_matching()->mutable_score()->mutable_groups(0)->add_labels("carr");
  EXPECT_THAT(
      std::string(PoseGraph::Create(options, scan_matching::SmallLabelSet()).status().message()),
      ::testing::StartsWith("pose_graph.scan_matching.score: "));
  options = Options();
  options.mutable_place_recognition()->mutable_groups(0)->add_labels("carr");
  EXPECT_THAT(
      std::string(PoseGraph::Create(options, scan_matching::SmallLabelSet()).status().message()),
      ::testing::StartsWith("pose_graph.place_recognition: "));
}

}  // namespace
}  // namespace cartographer::pose_graph
