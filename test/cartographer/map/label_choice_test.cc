// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/label_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glog/logging.h"
#include "test/testing/test_labels.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::SomeKittiLabels;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> Names(const absl::StatusOr<sensor::LabelMask>& mask) {
  CHECK(mask.ok()) << mask.status();
  const sensor::LabelSet labels = SomeKittiLabels();
  std::vector<std::string> names;
  for (size_t i = 0; i < sensor::kMaxLabels; ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    if (mask->Contains(label)) names.push_back(i < labels.size() ? labels.Name(label) : "?");
  }
  return names;
}

std::vector<std::string> Removed(const proto::FilterOptions& options) {
  return Names(LabelsToRemove(options, SomeKittiLabels()));
}

std::string Error(const proto::FilterOptions& options) {
  return std::string(LabelsToRemove(options, SomeKittiLabels()).status().message());
}

TEST(LabelChoiceTest, NothingNamedIsNothingRemoved) { EXPECT_THAT(Removed({}), IsEmpty()); }

TEST(LabelChoiceTest, NamesAndRolesAddUp) {
  proto::FilterOptions options;
  options.add_remove("building");
  options.add_remove("car");
  EXPECT_THAT(Removed(options), ElementsAre("car", "building"));
  options.add_remove_roles("movable");
  EXPECT_THAT(Removed(options),
              ElementsAre("car", "bicycle", "truck", "other-vehicle", "person", "building"));
}

TEST(LabelChoiceTest, UnlabeledHasARoleAsWell) {
  proto::FilterOptions options;
  options.add_remove_roles("unlabeled");
  EXPECT_THAT(Removed(options), ElementsAre("unlabeled"));
}

TEST(LabelChoiceTest, MergedNamesMeanTheirTarget) {
  proto::FilterOptions options;
  options.add_remove("lane-marking");
  EXPECT_THAT(Removed(options), ElementsAre("road"));
}

TEST(LabelChoiceTest, WhatIsNotKeptIsRemoved) {
  proto::FilterOptions options;
  options.add_keep("trunk");
  options.add_keep_roles("ground");
  options.add_keep_roles("movable");
  options.add_keep_roles("moving");
  EXPECT_THAT(Removed(options),
              ElementsAre("unlabeled", "building", "vegetation", "pole", "traffic-sign"));
}

TEST(LabelChoiceTest, ErrorsNameOptionAndRemedy) {
  proto::FilterOptions options;
  options.add_remove("trukc");
  EXPECT_THAT(Error(options), HasSubstr("remove: "));
  EXPECT_THAT(Error(options), HasSubstr("did you mean \"truck\"?"));
  options.Clear();
  options.add_keep("rode");
  EXPECT_THAT(Error(options), HasSubstr("keep: "));
  EXPECT_THAT(Error(options), HasSubstr("road"));
  options.Clear();
  options.add_remove_roles("movabel");
  EXPECT_EQ(Error(options), "remove_role: no role \"movabel\"; did you mean \"movable\"?");
  options.Clear();
  options.add_keep_roles("grund");
  EXPECT_EQ(Error(options), "keep_role: no role \"grund\"; did you mean \"ground\"?");
  options.Clear();
  options.add_keep("road");
  options.add_remove_roles("movable");
  EXPECT_THAT(Error(options), HasSubstr("give one of the two"));
}

}  // namespace
}  // namespace cartographer::map
