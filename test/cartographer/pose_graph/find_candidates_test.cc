// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/find_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "test/cartographer/pose_graph/small_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::NodeId;
using submap::SubmapId;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

proto::CandidateOptions Options() {
  proto::CandidateOptions options;
  options.set_min_travel_m(60.);
  options.set_max_distance_m(12.);
  options.set_max_nearby(2);
  options.mutable_window()->set_linear_m(1.);
  options.mutable_window()->set_linear_m_per_m(0.01);
  options.mutable_window()->set_angular_deg(2.);
  options.mutable_window()->set_angular_deg_per_m(0.1);
  options.mutable_window()->set_max_linear_m(2.9);
  options.mutable_window()->set_max_angular_deg(15.);
  options.set_place_window_above_m(2.5);
  options.set_place_linear_m(7.);
  options.set_place_angular_deg(10.);
  return options;
}

class FindCandidatesTest : public ::testing::Test {
 protected:
  FindCandidatesTest() { AddDrive(0, OutAndBack(100, 4.), 10, &graph_); }

  std::vector<OtherVisit> Visits(const NodeId& id) const {
    return FindOtherVisits(id, Options().min_travel_m(), graph_, Topology(graph_));
  }
  std::vector<ClosureCandidate> Nearby(const NodeId& id,
                                       const proto::CandidateOptions& options = Options()) const {
    return NearbyCandidates(id, Visits(id), options, graph_, Topology(graph_));
  }
  std::vector<SubmapId> Uncertain(const NodeId& id) const {
    return UncertainVisits(id, Visits(id), Options(), graph_, Topology(graph_));
  }

  Graph graph_;
};

TEST_F(FindCandidatesTest, WindowsGrowWithTheWay) {
  const auto window = WindowAfter(50., Options().window());
  EXPECT_DOUBLE_EQ(window.linear_m, 1.5);
  EXPECT_DOUBLE_EQ(window.angular_rad, 7. * M_PI / 180.);
  EXPECT_DOUBLE_EQ(WindowAfter(1000., Options().window()).angular_rad, 15. * M_PI / 180.);
  EXPECT_EQ(WindowAfter(kInfinity, Options().window()).linear_m, kInfinity);
}

TEST_F(FindCandidatesTest, WhatWasJustDrivenThroughIsNoOtherVisit) {
  // Node 120 is 19 m on the way back and 23 m after the turn; submap 8 is beside it.
  for (const OtherVisit& visit : Visits({0, 120})) {
    const int index = visit.submap_id.submap_index;
    EXPECT_TRUE(index < 6 || index >= 17) << index;
  }
  EXPECT_TRUE(Nearby({0, 120}).empty());
  // Node 151 is at x = 50, 104 m after the middle of submap 4 was passed, 94 m after that of 5.
  const std::vector<ClosureCandidate> nearby = Nearby({0, 151});
  ASSERT_EQ(nearby.size(), 2u);
  EXPECT_EQ(nearby[0].submap_id.submap_index, 4);
  EXPECT_EQ(nearby[1].submap_id.submap_index, 5);
}

TEST_F(FindCandidatesTest, GuessIsTheMapsEstimate) {
  const ClosureCandidate candidate = Nearby({0, 151}).front();
  // The submap begins at x = 40; the way back leads against it.
  EXPECT_NEAR(candidate.submap_from_node_guess.translation.x(), 10., 1e-9);
  EXPECT_NEAR(candidate.submap_from_node_guess.translation.y(), 4., 1e-9);
  EXPECT_NEAR(std::abs(candidate.submap_from_node_guess.yaw_rad), M_PI, 1e-9);
  EXPECT_NEAR(candidate.window.linear_m, 1. + 0.01 * (151. - 45. + 3.), 1e-9);
  EXPECT_FALSE(candidate.by_place_recognition);
}

TEST_F(FindCandidatesTest, UnfinishedSubmapsAndFarOnesAreNone) {
  auto growing = std::make_shared<submap::Submap>(0.2);
  graph_.submaps.at({0, 4}).submap = growing;
  EXPECT_EQ(Nearby({0, 151}).front().submap_id.submap_index, 5);
  proto::CandidateOptions narrow = Options();
  narrow.set_max_distance_m(3.);
  EXPECT_TRUE(Nearby({0, 151}, narrow).empty());
}

TEST_F(FindCandidatesTest, TooUncertainOnesAreLeftToPlaceRecognition) {
  // At the end of the way back 199 m lie in between, which is a window of 2.99 m.
  EXPECT_TRUE(Nearby({0, 201}).empty());
  const std::vector<SubmapId> uncertain = Uncertain({0, 201});
  ASSERT_EQ(uncertain.size(), 1u);
  EXPECT_EQ(uncertain[0].submap_index, 0);
  EXPECT_TRUE(Uncertain({0, 151}).empty());
  // A closure on the way makes the estimate certain again.
  graph_.constraints.push_back(
      ClosureBetween({0, 2}, {0, 176}, graph_.nodes.at({0, 176}).map_from_node, graph_));
  EXPECT_FALSE(Nearby({0, 201}).empty());
  EXPECT_TRUE(Uncertain({0, 201}).empty());
}

TEST_F(FindCandidatesTest, UntiedTrajectoriesAreUncertainWhereverTheyAre) {
  AddDrive(1, OutAndBack(5, 4.), 3, &graph_);
  EXPECT_TRUE(Nearby({1, 0}).empty());
  EXPECT_EQ(Uncertain({1, 0}).size(), graph_.submaps.size() - 4);
}

TEST_F(FindCandidatesTest, EverywhereNoSubmapIsFartherThanHalfAWindowFromOneThatIsSearched) {
  const Topology topology(graph_);
  std::vector<SubmapId> all;
  for (const auto& [id, placed] : graph_.submaps) all.push_back(id);
  proto::SearchAllOptions options;
  options.set_linear_m(30.);
  const auto position = [&](const SubmapId& id) -> Eigen::Vector2d {
    return graph_.nodes.at(*topology.MiddleNode(id)).map_from_node.translation().head<2>();
  };
  const std::vector<ClosureCandidate> candidates =
      CandidatesEverywhere({0, 7}, all, options, graph_, topology);
  // The way back lies beside the way out, and submaps follow each other every 10 m.
  EXPECT_LT(candidates.size(), all.size() / 2);
  for (const SubmapId& id : all) {
    double nearest_m = kInfinity;
    for (const ClosureCandidate& candidate : candidates) {
      nearest_m = std::min(nearest_m, (position(candidate.submap_id) - position(id)).norm());
    }
    EXPECT_LT(nearest_m, 15.) << id.submap_index;
  }
  for (const ClosureCandidate& candidate : candidates) {
    EXPECT_EQ(candidate.node_id, (NodeId{0, 7}));
    EXPECT_EQ(candidate.window.linear_m, 30.);
    EXPECT_GE(candidate.window.angular_rad, M_PI);
    // Around the middle node, as the submap has it.
    const Eigen::Vector3d guess(candidate.submap_from_node_guess.translation.x(),
                                candidate.submap_from_node_guess.translation.y(), 0.);
    const Eigen::Vector3d in_map = graph_.submaps.at(candidate.submap_id).map_from_submap * guess;
    EXPECT_LT((in_map.head<2>() - position(candidate.submap_id)).norm(), 1e-9);
  }
  EXPECT_TRUE(CandidatesEverywhere({0, 7}, {}, options, graph_, topology).empty());
}

TEST_F(FindCandidatesTest, ProposalsAreTurnedToTheNode) {
  PlaceCandidate place;
  place.submap_id = {0, 3};
  place.submap_from_query = {{1., 2.}, M_PI / 2.};
  const ClosureCandidate candidate = CandidateAtPlace({0, 151}, place, {{5., 0.}, 0.1}, Options());
  EXPECT_TRUE(candidate.by_place_recognition);
  EXPECT_TRUE(candidate.submap_id == place.submap_id);
  EXPECT_NEAR(candidate.submap_from_node_guess.translation.x(), 1., 1e-9);
  EXPECT_NEAR(candidate.submap_from_node_guess.translation.y(), 7., 1e-9);
  EXPECT_NEAR(candidate.submap_from_node_guess.yaw_rad, M_PI / 2. + 0.1, 1e-9);
  EXPECT_DOUBLE_EQ(candidate.window.linear_m, 7.);
  EXPECT_DOUBLE_EQ(candidate.window.angular_rad, 10. * M_PI / 180.);
}

}  // namespace
}  // namespace cartographer::pose_graph
