// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/hidden_labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glog/logging.h"
#include "test/testing/test_labels.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::SomeKittiLabels;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The labels that are left, by name.
std::vector<std::string> Shown(const absl::StatusOr<sensor::LabelMask>& hidden) {
  CHECK(hidden.ok()) << hidden.status();
  const sensor::LabelSet labels = SomeKittiLabels();
  std::vector<std::string> names;
  for (size_t i = 0; i < labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    if (!hidden->Contains(label)) names.push_back(labels.Name(label));
  }
  return names;
}

proto::RenderOptions Options(const std::vector<std::string>& hide,
                             const std::vector<std::string>& show) {
  proto::RenderOptions options;
  for (const std::string& name : hide) options.add_hide(name);
  for (const std::string& name : show) options.add_show(name);
  return options;
}

TEST(HiddenLabelsTest, AllAreShownUnlessSomeAreNamed) {
  const sensor::LabelSet labels = SomeKittiLabels();
  EXPECT_EQ(Shown(HiddenLabels(Options({}, {}), labels)).size(), labels.size());
  EXPECT_EQ(Shown(HiddenLabels(Options({"car", "lane-marking"}, {}), labels)).size(),
            labels.size() - 2);
  EXPECT_THAT(Shown(HiddenLabels(Options({}, {"pole", "car"}), labels)),
              ElementsAre("car", "pole"));
  EXPECT_THAT(Shown(HiddenLabels(Options({"car"}, {"pole", "car"}), labels)), ElementsAre("pole"));
}

TEST(HiddenLabelsTest, OccupancyShowsTheGroundAndNothingThatMoves) {
  const sensor::LabelSet labels = SomeKittiLabels();
  EXPECT_THAT(Shown(LabelsHiddenFromOccupancy(Options({}, {}), labels)),
              ElementsAre("unlabeled", "car", "bicycle", "truck", "other-vehicle", "person", "road",
                          "sidewalk", "building", "vegetation", "trunk", "pole", "traffic-sign"));
  EXPECT_THAT(Shown(LabelsHiddenFromOccupancy(Options({}, {"building"}), labels)),
              ElementsAre("road", "sidewalk", "building"));
  EXPECT_THAT(Shown(LabelsHiddenFromOccupancy(Options({"sidewalk"}, {"moving-car"}), labels)),
              ElementsAre("road", "moving-car"));
}

TEST(HiddenLabelsTest, ErrorsNameOptionAndRemedy) {
  const auto error = [](const proto::RenderOptions& options) {
    EXPECT_EQ(HiddenLabels(options, SomeKittiLabels()).status(),
              LabelsHiddenFromOccupancy(options, SomeKittiLabels()).status());
    return std::string(HiddenLabels(options, SomeKittiLabels()).status().message());
  };
  EXPECT_THAT(error(Options({"trukc"}, {})), HasSubstr("hide: "));
  EXPECT_THAT(error(Options({"trukc"}, {})), HasSubstr("did you mean \"truck\"?"));
  EXPECT_THAT(error(Options({}, {"rode"})), HasSubstr("show: "));
}

}  // namespace
}  // namespace cartographer::io
