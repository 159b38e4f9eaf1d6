// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/configuration_difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cartographer/common/options_loader.h"
#include "semantic_kiss/cli/proto/run_options.pb.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::common::OptionsToLua;
using ::testing::ElementsAre;
using ::testing::FieldsAre;
using ::testing::IsEmpty;

TEST(ConfigurationDifferenceTest, EqualConfigurationsDoNotDiffer) {
  const std::string lua = OptionsToLua(proto::RunOptions());
  EXPECT_THAT(Differences(lua, lua), IsEmpty());
  EXPECT_THAT(Differences("", ""), IsEmpty());
}

TEST(ConfigurationDifferenceTest, NamesWholePaths) {
  proto::RunOptions one, other;
  one.set_label_set("a = {");
  one.mutable_pose_graph()->mutable_optimization()->set_dof(3);
  other.mutable_pose_graph()->mutable_optimization()->set_dof(6);
  EXPECT_THAT(Differences(OptionsToLua(one), OptionsToLua(other)),
              ElementsAre(FieldsAre("label_set", "\"a = {\"", "\"\""),
                          FieldsAre("pose_graph.optimization.dof", "3", "6")));
}

TEST(ConfigurationDifferenceTest, ListsDifferByElement) {
  proto::RunOptions one, other;
  for (const char* name : {"car", "a = b", "bus"}) one.mutable_map_image()->add_hide(name);
  other.mutable_map_image()->add_hide("car");
  other.mutable_map_image()->add_hide("van");
  EXPECT_THAT(Differences(OptionsToLua(one), OptionsToLua(other)),
              ElementsAre(FieldsAre("map_image.hide[2]", "\"a = b\"", "\"van\""),
                          FieldsAre("map_image.hide[3]", "\"bus\"", "")));
}

TEST(ConfigurationDifferenceTest, TablesOnOneLineAreValues) {
  const std::string one =
      "return {\n  stages = {\n    { a = 1, b = 2 },\n    { a = 3 },\n  },\n}\n";
  const std::string other = "return {\n  stages = {\n    { a = 1, b = 2 },\n  },\n  x = 1,\n}\n";
  EXPECT_THAT(Differences(one, other),
              ElementsAre(FieldsAre("stages[2]", "{ a = 3 }", ""), FieldsAre("x", "", "1")));
}

}  // namespace
}  // namespace semantic_kiss::cli
