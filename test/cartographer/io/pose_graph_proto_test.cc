// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/pose_graph_proto.h"

#include <cmath>

#include "test/testing/small_map.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::SmallMap;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ProtoConstraint = mapping::proto::PoseGraph::Constraint;

// Trajectories 1 and 4 of two nodes (3 and 4) and a submap (0) each, and 5 constraints.
mapping::proto::PoseGraph Good() { return ToProto(SmallMap(2, 1)); }

std::string ErrorOf(const mapping::proto::PoseGraph& proto) {
  return std::string(FromProto(proto).status().message());
}

TEST(PoseGraphProtoTest, ComesBack) {
  const auto graph = FromProto(Good());
  ASSERT_TRUE(graph.ok()) << graph.status();
  EXPECT_THAT(graph->trajectory_ids, ElementsAre(1, 4));
  EXPECT_EQ(graph->nodes.size(), 4u);
  EXPECT_EQ(graph->map_from_submap.size(), 2u);
  EXPECT_EQ(graph->constraints.size(), 5u);
  EXPECT_EQ(OptionsFor(Good()).options_with_sensor_ids_size(), 2);
  EXPECT_TRUE(FromProto(mapping::proto::PoseGraph())->nodes.empty());
}

TEST(PoseGraphProtoTest, TrajectoriesAreChecked) {
  mapping::proto::PoseGraph proto = Good();
  proto.mutable_trajectory(1)->set_trajectory_id(1);
  EXPECT_EQ(ErrorOf(proto), "trajectory 1 is listed twice or negative");
  proto.mutable_trajectory(1)->set_trajectory_id(-1);
  EXPECT_EQ(ErrorOf(proto), "trajectory -1 is listed twice or negative");
  proto.mutable_trajectory(1)->set_trajectory_id(INT32_MAX);
  EXPECT_EQ(ErrorOf(proto), "trajectory 2147483647 has a number above 1000000000");
}

TEST(PoseGraphProtoTest, NodesAndSubmapsAreChecked) {
  mapping::proto::PoseGraph proto = Good();
  proto.mutable_trajectory(0)->mutable_node(1)->set_node_index(3);
  EXPECT_EQ(ErrorOf(proto), "node (1, 3) is listed twice");
  proto.mutable_trajectory(0)->mutable_node(1)->set_node_index(-2);
  EXPECT_EQ(ErrorOf(proto), "node (1, -2) has a negative index");
  proto = Good();
  *proto.mutable_trajectory(1)->add_submap() = proto.trajectory(1).submap(0);
  EXPECT_EQ(ErrorOf(proto), "submap (4, 0) is listed twice");
  proto = Good();
  proto.mutable_trajectory(0)->mutable_node(1)->set_timestamp(0);
  EXPECT_EQ(ErrorOf(proto), "node (1, 4) is older than node (1, 3)");
}

TEST(PoseGraphProtoTest, PosesAreChecked) {
  mapping::proto::PoseGraph proto = Good();
  proto.mutable_trajectory(0)->mutable_node(0)->clear_pose();
  EXPECT_THAT(ErrorOf(proto), HasSubstr("node (1, 3): the rotation (w, x, y, z) = (0, 0, 0, 0)"));
  auto* const pose = proto.mutable_trajectory(0)->mutable_node(0)->mutable_pose();
  pose->mutable_rotation()->set_w(1.01);
  EXPECT_THAT(ErrorOf(proto), HasSubstr("is no unit quaternion"));
  pose->mutable_rotation()->set_w(std::nan(""));
  EXPECT_THAT(ErrorOf(proto), HasSubstr("is no unit quaternion"));
  pose->mutable_rotation()->set_w(-1.);
  EXPECT_EQ(ErrorOf(proto), "");
  pose->mutable_translation()->set_y(HUGE_VAL);
  EXPECT_EQ(ErrorOf(proto), "node (1, 3): the translation (0, inf, 0) is not finite");
}

TEST(PoseGraphProtoTest, ConstraintsAreChecked) {
  const auto error_of = [](const auto& change) {
    mapping::proto::PoseGraph proto = Good();
    change(proto.mutable_constraint(1));
    return ErrorOf(proto);
  };
  EXPECT_EQ(error_of([](ProtoConstraint* c) { c->mutable_submap_id()->set_submap_index(9); }),
            "constraint 1: submap (1, 9) does not exist");
  EXPECT_EQ(error_of([](ProtoConstraint* c) { c->mutable_node_id()->set_trajectory_id(2); }),
            "constraint 1: node (2, 4) does not exist");
  EXPECT_EQ(error_of([](ProtoConstraint* c) { c->mutable_node_id()->set_node_index(3); }),
            "constraint 1: node (1, 3) is in submap (1, 0) twice");
  EXPECT_EQ(error_of([](ProtoConstraint* c) { c->set_rotation_weight(-1.); }),
            "constraint 1: the weight -1 is negative or not finite");
  EXPECT_EQ(error_of([](ProtoConstraint* c) { c->set_translation_weight(std::nan("")); }),
            "constraint 1: the weight nan is negative or not finite");
  EXPECT_EQ(error_of([](ProtoConstraint* c) { c->set_tag(static_cast<ProtoConstraint::Tag>(7)); }),
            "constraint 1: unknown kind 7");
  EXPECT_EQ(error_of([](ProtoConstraint* c) {
              c->mutable_submap_id()->set_trajectory_id(4);
              c->mutable_submap_id()->set_submap_index(0);
              c->set_tag(ProtoConstraint::INTRA_SUBMAP);
            }),
            "constraint 1: node (1, 4) cannot be in submap (4, 0), which is of another trajectory");
  EXPECT_THAT(error_of([](ProtoConstraint* c) { c->clear_relative_pose(); }),
              HasSubstr("constraint 1: the rotation"));
}

}  // namespace
}  // namespace cartographer::io
