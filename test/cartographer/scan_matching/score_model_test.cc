// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/score_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "cartographer/common/options_loader.h"
#include "test/cartographer/scan_matching/small_scenes.h"

namespace cartographer::scan_matching {
namespace {

using ::testing::HasSubstr;

TEST(ScoreModelTest, LabelsBelongToTheGroupThatNamesThemThenToThatOfTheirRoleThenToTheRest) {
  proto::ScoreOptions options;
  options.set_score("dominant_label");
  AddGroup("rest", {}, 1., 1, false, &options);
  AddGroup("ground", {"ground"}, 0.5, 1, false, &options);
  AddGroup("walls", {}, 2., 1, false, &options);
  options.mutable_groups(2)->add_labels("building");
  options.mutable_groups(2)->add_labels("sidewalk");
  const ScoreModel model = SmallModel(options);
  const auto weight = [&](int label) { return model.WeightOf(LabelAt(label)) / 64.; };
  EXPECT_EQ(weight(2), 0.5);  // road
  EXPECT_EQ(weight(3), 2.);   // sidewalk
  EXPECT_EQ(weight(4), 2.);   // building
  for (const int rest : {0, 1, 5, 6, 7, 8}) EXPECT_EQ(weight(rest), 1.) << rest;
  EXPECT_EQ(model.num_groups(), 3);
  EXPECT_EQ(model.num_layers(), kNumSmallLabels);
}

TEST(ScoreModelTest, LabelsWithoutWeightOrGroupAreNotMatched) {
  proto::ScoreOptions options;
  options.set_score("dominant_label");
  AddGroup("ground", {"ground"}, 0., 1, false, &options);
  AddGroup("critical", {"critical"}, 1., 1, false, &options);
  const ScoreModel model = SmallModel(options);
  for (int label = 0; label < kNumSmallLabels; ++label) {
    EXPECT_EQ(model.LayerOf(LabelAt(label)) != ScoreModel::kNotMatched, label == 6 || label == 7);
  }
  EXPECT_EQ(model.num_layers(), 2);
  EXPECT_EQ(model.num_groups(), 1);
  EXPECT_EQ(SmallModel(proto::ScoreOptions()).num_groups(), 0);
}

TEST(ScoreModelTest, ApartMeansAGroupOfItsOwnForEveryLabel) {
  proto::ScoreOptions options;
  options.set_score("max_layer");
  AddGroup("critical", {"critical"}, 1., 1, false, &options);
  AddGroup("ground", {"ground"}, 1., 1, true, &options);
  const ScoreModel model = SmallModel(options);
  EXPECT_EQ(model.GroupOf(model.LayerOf(LabelAt(6))), model.GroupOf(model.LayerOf(LabelAt(7))));
  EXPECT_NE(model.GroupOf(model.LayerOf(LabelAt(2))), model.GroupOf(model.LayerOf(LabelAt(3))));
  EXPECT_EQ(model.num_groups(), 3);
}

TEST(ScoreModelTest, AgreementGrowsInProportionAndSaturates) {
  const ScoreModel model = SmallModel(SmallOptions("dominant_label", 0.5, 4));
  EXPECT_EQ(model.Agreement(0, 0, true), 0);
  EXPECT_EQ(model.Agreement(0, 1, true), 64);
  EXPECT_EQ(model.Agreement(0, 2, true), 128);
  EXPECT_EQ(model.Agreement(0, 4, true), 255);
  EXPECT_EQ(model.Agreement(0, 60000, true), 255);
  EXPECT_EQ(model.Agreement(0, 4, false), 128);
  EXPECT_EQ(SmallModel(SmallOptions("dominant_label")).Agreement(0, 9, false), 0);
  EXPECT_EQ(SmallModel(SmallOptions("max_layer")).Agreement(0, 9, false), 255);
  EXPECT_EQ(SmallModel(SmallOptions("occupancy")).Agreement(0, 1, false), 255);
}

TEST(ScoreModelTest, ErrorsNameTheGroup) {
  const sensor::LabelSet labels = SmallLabelSet();
  proto::ScoreOptions unknown_label = SmallOptions("dominant_label");
  unknown_label.mutable_groups(1)->add_labels("poel");
  EXPECT_EQ(ScoreModel::Create(unknown_label, labels).status().message(),
            "group \"critical\": no class \"poel\" in label set \"small\"; did you mean \"pole\"?");
  proto::ScoreOptions unknown_role = SmallOptions("dominant_label");
  unknown_role.mutable_groups(2)->add_roles("movabel");
  EXPECT_EQ(ScoreModel::Create(unknown_role, labels).status().message(),
            "group \"movable\": no role \"movabel\"; did you mean \"movable\"?");
  proto::ScoreOptions twice = SmallOptions("dominant_label");
  twice.mutable_groups(1)->add_labels("pole");
  twice.mutable_groups(3)->add_labels("pole");
  EXPECT_EQ(ScoreModel::Create(twice, labels).status().message(),
            "group \"weak\": label \"pole\" is in another group already");
}

TEST(ScoreModelTest, TheShippedOptionsServeEveryShippedLabelSet) {
  const char* const root = std::getenv("SEMANTIC_KISS_SOURCE_DIR");
  ASSERT_NE(root, nullptr);
  const std::string files = std::string(root) + "/configuration_files";
  proto::ScanMatchingOptions options;
  ASSERT_EQ(
      common::LoadOptionsFromString("include \"defaults/scan_matching.lua\"\nreturn SCAN_MATCHING",
                                    "test", {files}, &options)
          .message(),
      "");
  for (const std::string name : {"semantic_kitti", "nuscenes"}) {
    const auto labels = sensor::LabelSet::Load({files + "/labels/" + name + ".lua", {}});
    ASSERT_TRUE(labels.ok()) << labels.status();
    const auto model = ScoreModel::Create(options.score(), *labels);
    ASSERT_TRUE(model.ok()) << model.status();
    for (size_t i = 0; i < labels->size(); ++i) {
      const sensor::Label label{static_cast<uint8_t>(i)};
      EXPECT_EQ(model->WeightOf(label) == 0, labels->HasRole(label, sensor::LabelRole::kMoving))
          << labels->Name(label);
    }
  }
  const std::string bad =
      "include \"defaults/scan_matching.lua\"\nSCAN_MATCHING.score.score = 'dominant'\n"
      "return SCAN_MATCHING";
  EXPECT_THAT(std::string(common::LoadOptionsFromString(bad, "test", {files}, &options).message()),
              HasSubstr("score.score"));
}

}  // namespace
}  // namespace cartographer::scan_matching
