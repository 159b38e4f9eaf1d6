// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/agreement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/cartographer/pose_graph/small_drive.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;
using transform::Rigid3d;

class AgreementTest : public ::testing::Test {
 protected:
  AgreementTest() {
    AddDrive(0, OutAndBack(100, 4.), 10, &graph_);
    options_.set_max_travel_m(30.);
    options_.set_max_distance_m(0.5);
    options_.set_max_distance_m_per_m(0.01);
    options_.set_max_angle_deg(1.);
  }

  // A closure that wants its node to be moved by `corrected_from_estimate`.
  Constraint Moving(const SubmapId& submap_id, const NodeId& node_id,
                    const Rigid3d& corrected_from_estimate) const {
    return ClosureBetween(submap_id, node_id,
                          corrected_from_estimate * graph_.nodes.at(node_id).map_from_node, graph_);
  }
  bool AgreeOn(const Constraint& a, const Constraint& b) const {
    return Agree(a, b, graph_, Topology(graph_), options_);
  }

  Graph graph_;
  proto::AgreementOptions options_;
};

TEST_F(AgreementTest, CorrectionIsWhatMovesTheNode) {
  const Rigid3d move({1., -2., 0.5}, Eigen::Quaterniond(Eigen::AngleAxisd(
                                         0.2, Eigen::Vector3d(1., 2., 3.).normalized())));
  const Rigid3d correction = CorrectionBy(Moving({0, 2}, {0, 180}, move), graph_);
  EXPECT_LT((correction.Matrix() - move.Matrix()).norm(), 1e-9);
}

TEST_F(AgreementTest, TheSameStoryAgreesWhateverTheSubmap) {
  const Rigid3d drift = Rigid3d::Translation({3., 1., 2.});
  const Constraint a = Moving({0, 2}, {0, 180}, drift);
  EXPECT_TRUE(AgreeOn(a, Moving({0, 1}, {0, 190}, drift)));
  EXPECT_TRUE(AgreeOn(a, Moving({0, 1}, {0, 190}, Rigid3d::Translation({3.5, 1., 2.}))));
  EXPECT_FALSE(AgreeOn(a, Moving({0, 1}, {0, 190}, Rigid3d::Translation({3.7, 1., 2.}))));
  EXPECT_FALSE(AgreeOn(a, Moving({0, 1}, {0, 190}, Rigid3d::Identity())));
}

TEST_F(AgreementTest, RotationsAgreeWhereTheNodesAre) {
  // About the origin this turn moves the nodes, which are 15 m away, by 0.2 m.
  const double angle_rad = 0.8 * M_PI / 180.;
  const Rigid3d turn =
      Rigid3d::Rotation(Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ())));
  const Constraint still = Moving({0, 1}, {0, 185}, Rigid3d::Identity());
  EXPECT_TRUE(AgreeOn(still, Moving({0, 1}, {0, 187}, turn)));
  EXPECT_FALSE(AgreeOn(still, Moving({0, 1}, {0, 187}, turn * turn)));
}

TEST_F(AgreementTest, FarNodesAndOtherDrivesHaveNoSay) {
  AddDrive(1, OutAndBack(100, 4.), 10, &graph_);
  const Constraint a = Moving({0, 2}, {0, 170}, Rigid3d::Identity());
  EXPECT_FALSE(AgreeOn(a, Moving({0, 0}, {0, 201}, Rigid3d::Identity())));
  EXPECT_FALSE(AgreeOn(a, Moving({0, 2}, {1, 170}, Rigid3d::Identity())));
}

TEST_F(AgreementTest, CountsNeighboursOtherThanTheNodeItself) {
  const Rigid3d drift = Rigid3d::Translation({3., 1., 2.});
  std::vector<Closure> closures(4);
  closures[0].constraint = Moving({0, 2}, {0, 180}, drift);
  closures[1].constraint = Moving({0, 1}, {0, 180}, drift);  // the same node
  closures[2].constraint = Moving({0, 1}, {0, 184}, drift);
  closures[3].constraint = Moving({0, 1}, {0, 188}, Rigid3d::Identity());
  const Topology topology(graph_);
  EXPECT_THAT(CountAgreeing(closures, 4, graph_, topology, options_),
              ::testing::ElementsAre(1, 1, 2, 0));
  EXPECT_THAT(CountAgreeing(closures, 1, graph_, topology, options_), ::testing::ElementsAre(1));
  EXPECT_TRUE(CountAgreeing({}, 0, graph_, topology, options_).empty());
}

}  // namespace
}  // namespace cartographer::pose_graph
