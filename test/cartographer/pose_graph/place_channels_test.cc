// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "test/cartographer/pose_graph/place_scenes.h"

namespace cartographer::pose_graph {
namespace {

using sensor::LabelRole;
using ::testing::HasSubstr;

TEST(PlaceChannelsTest, ShippedGroupsTakeWhatStaysAndStandsInAnyLabelSet) {
  for (const std::string name : {"semantic_kitti", "nuscenes"}) {
    const sensor::LabelSet labels = ShippedLabels(name);
    const auto channels = PlaceChannels::Create(ShippedPlaceOptions(), labels);
    ASSERT_TRUE(channels.ok()) << channels.status();
    std::set<int> used;
    for (size_t i = 0; i < labels.size(); ++i) {
      const sensor::Label label{static_cast<uint8_t>(i)};
      const bool passes = labels.HasRole(label, LabelRole::kMoving) ||
                          labels.HasRole(label, LabelRole::kMovable) ||
                          labels.HasRole(label, LabelRole::kGround);
      EXPECT_EQ(channels->ChannelOf(label) == PlaceChannels::kNotUsed, passes)
          << labels.Name(label);
      if (!passes) used.insert(channels->ChannelOf(label));
    }
    // All channels have a label, and count.
    EXPECT_EQ(used.size(), channels->size());
    for (const int channel : used) {
      ASSERT_LT(channel, channels->size());
      EXPECT_GT((*channels)[channel].weight, 0.f);
      EXPECT_GT((*channels)[channel].saturation_hits, 0.f);
    }
  }
}

TEST(PlaceChannelsTest, CriticalLabelsShareAChannelAndStructuresDoNot) {
  const sensor::LabelSet labels = ShippedLabels();
  const auto channels = PlaceChannels::Create(ShippedPlaceOptions(), labels).value();
  const auto channel_of = [&](const std::string& name) {
    return channels.ChannelOf(labels.FromName(name).value());
  };
  EXPECT_EQ(channel_of("pole"), channel_of("traffic-sign"));
  EXPECT_NE(channel_of("building"), channel_of("vegetation"));
  EXPECT_NE(channel_of("building"), channel_of("pole"));
}

TEST(PlaceChannelsTest, NamesTheGroupThatIsWrong) {
  const auto options = ShippedPlaceOptions("PLACE_RECOGNITION.groups[3].roles = { \"criticle\" }");
  EXPECT_THAT(std::string(PlaceChannels::Create(options, ShippedLabels()).status().message()),
              HasSubstr("group \"critical\": no role \"criticle\""));
}

}  // namespace
}  // namespace cartographer::pose_graph
