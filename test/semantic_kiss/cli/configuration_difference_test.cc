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

TEST(ConfigurationDifferenceTest, ShortListsAreValues) {
  proto::RunOptions one, other;
  one.mutable_map_image()->add_hide("a = b");
  EXPECT_THAT(Differences(OptionsToLua(one), OptionsToLua(other)),
              ElementsAre(FieldsAre("map_image.hide", "{ \"a = b\" }", "{}")));
}

TEST(ConfigurationDifferenceTest, LongListsDifferByElement) {
  proto::RunOptions one, other;
  for (int i = 0; i < 40; ++i) {
    one.mutable_dataset()->add_confidence_columns(i);
    other.mutable_dataset()->add_confidence_columns(i == 20 ? 1000 : i);
  }
  EXPECT_THAT(Differences(OptionsToLua(one), OptionsToLua(other)),
              ElementsAre(FieldsAre("dataset.confidence_columns[21]", "20", "1000")));
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
