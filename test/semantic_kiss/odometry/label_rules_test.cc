// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/odometry/label_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "test/testing/test_labels.h"

namespace semantic_kiss::odometry {
namespace {

using cartographer::sensor::Label;
using cartographer::sensor::LabelMask;
using cartographer::sensor::LabelSet;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

const LabelSet& Labels() {
  static const LabelSet& labels = *new LabelSet(semantic_kiss_testing::SomeKittiLabels());
  return labels;
}

std::vector<std::string> Names(const LabelMask& mask) {
  std::vector<std::string> names;
  for (size_t i = 0; i < Labels().size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (mask.Contains(label)) names.push_back(Labels().Name(label));
  }
  return names;
}

std::string Error(const proto::OdometryOptions& options) {
  return std::string(LabelRules::Create(options, Labels()).status().message());
}

TEST(LabelRulesTest, RolesDecideWhereNothingIsNamed) {
  proto::OdometryOptions options;
  EXPECT_THAT(Names(LabelRules::Create(options, Labels())->dropped), UnorderedElementsAre());
  options.mutable_preprocessing()->set_drop_moving(true);
  const LabelRules rules = *LabelRules::Create(options, Labels());
  EXPECT_THAT(Names(rules.dropped),
              UnorderedElementsAre("moving-car", "moving-person", "moving-motorcyclist"));
  EXPECT_THAT(Names(rules.critical), UnorderedElementsAre("pole", "traffic-sign"));
  EXPECT_TRUE(rules.map_classes.empty());
  EXPECT_TRUE(rules.icp_classes.empty());
}

TEST(LabelRulesTest, NamesComeOnTop) {
  proto::OdometryOptions options;
  options.mutable_preprocessing()->add_drop_labels("person");
  options.add_critical_labels("trunk");
  proto::ClassVoxels& ground = *options.mutable_map_subsampling()->add_class_voxels();
  ground.add_labels("road");
  ground.add_labels("sidewalk");
  options.mutable_map_subsampling()->add_class_voxels()->add_labels("unlabeled");
  const LabelRules rules = *LabelRules::Create(options, Labels());
  EXPECT_THAT(Names(rules.dropped), UnorderedElementsAre("person"));
  EXPECT_THAT(Names(rules.critical), UnorderedElementsAre("pole", "traffic-sign", "trunk"));
  ASSERT_EQ(rules.map_classes.size(), 2);
  EXPECT_THAT(Names(rules.map_classes[0]), UnorderedElementsAre("road", "sidewalk"));
  EXPECT_THAT(Names(rules.map_classes[1]), UnorderedElementsAre("unlabeled"));
  EXPECT_TRUE(rules.icp_classes.empty());
}

TEST(LabelRulesTest, ErrorsNameTheOption) {
  proto::OdometryOptions options;
  options.mutable_preprocessing()->add_drop_labels("preson");
  EXPECT_THAT(Error(options), HasSubstr("preprocessing.drop_labels: "));
  EXPECT_THAT(Error(options), HasSubstr("person"));
  options.Clear();
  options.add_critical_labels("trnuk");
  EXPECT_THAT(Error(options), HasSubstr("critical_labels: "));
  options.Clear();
  options.mutable_icp_subsampling()->add_class_voxels()->add_labels("raod");
  EXPECT_THAT(Error(options), HasSubstr("icp_subsampling.class_voxels: "));
  options.Clear();
  options.mutable_map_subsampling()->add_class_voxels()->add_labels("road");
  options.mutable_map_subsampling()->add_class_voxels()->add_labels("lane-marking");
  EXPECT_EQ(Error(options),
            "map_subsampling.class_voxels: class \"lane-marking\" is in another group already");
}

}  // namespace
}  // namespace semantic_kiss::odometry
