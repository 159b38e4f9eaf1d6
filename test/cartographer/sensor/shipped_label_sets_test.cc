// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

// The label sets in configuration_files/labels, and the one that docs/labels.md shows.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "cartographer/common/options_loader.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::sensor {
namespace {

using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

std::string SourcePath(const std::string& path) {
  const char* const directory = std::getenv("SEMANTIC_KISS_SOURCE_DIR");
  return (directory == nullptr ? std::string(".") : std::string(directory)) + "/" + path;
}

LabelSet LoadShipped(const std::string& name) {
  absl::StatusOr<LabelSet> set =
      LabelSet::Load({SourcePath("configuration_files/labels/" + name), {}});
  EXPECT_TRUE(set.ok()) << set.status();
  return set.ok() ? *std::move(set) : LabelSet();
}

std::vector<std::string> NamesWithRole(const LabelSet& set, LabelRole role) {
  std::vector<std::string> names;
  for (size_t i = 0; i < set.size(); ++i) {
    const Label label{static_cast<uint8_t>(i)};
    if (set.HasRole(label, role)) names.push_back(set.Name(label));
  }
  return names;
}

TEST(SemanticKittiLabelsTest, ListEveryIdOfTheFiles) {
  const LabelSet set = LoadShipped("semantic_kitti.lua");
  for (const int id :
       {0,  1,  9,  10, 11, 13, 15, 16, 18, 20,  30,  31,  32,  40,  44,  48,  49,  50,
        51, 52, 60, 70, 71, 72, 80, 81, 99, 251, 252, 253, 254, 255, 256, 257, 258, 259}) {
    EXPECT_TRUE(set.FromFileId(static_cast<uint16_t>(id)).has_value()) << id;
  }
  EXPECT_FALSE(set.FromFileId(2).has_value());
  EXPECT_FALSE(set.FromFileId(260).has_value());
}

TEST(SemanticKittiLabelsTest, GiveTheRoles) {
  const LabelSet set = LoadShipped("semantic_kitti.lua");
  EXPECT_THAT(NamesWithRole(set, LabelRole::kMoving),
              UnorderedElementsAre("moving", "moving-car", "moving-bicyclist", "moving-person",
                                   "moving-motorcyclist", "moving-truck", "moving-other-vehicle"));
  EXPECT_THAT(NamesWithRole(set, LabelRole::kMovable),
              UnorderedElementsAre("car", "bicycle", "motorcycle", "truck", "other-vehicle",
                                   "person", "bicyclist", "motorcyclist"));
  EXPECT_THAT(NamesWithRole(set, LabelRole::kCritical),
              UnorderedElementsAre("pole", "traffic-sign"));
  EXPECT_THAT(NamesWithRole(set, LabelRole::kGround),
              UnorderedElementsAre("road", "parking", "sidewalk", "other-ground", "terrain"));
  EXPECT_THAT(NamesWithRole(set, LabelRole::kUnlabeled), UnorderedElementsAre("unlabeled"));
}

TEST(SemanticKittiLabelsTest, MergeAsTheUsual19ClassesButKeepMovingApart) {
  const LabelSet set = LoadShipped("semantic_kitti.lua");
  const auto name = [&](uint16_t id) { return set.Name(*set.FromFileId(id)); };
  EXPECT_EQ(name(13), "other-vehicle");
  EXPECT_EQ(name(16), "other-vehicle");
  EXPECT_EQ(name(60), "road");
  for (const uint16_t id : {1, 9, 52, 99}) EXPECT_EQ(name(id), "unlabeled");
  EXPECT_EQ(name(256), "moving-other-vehicle");
  EXPECT_EQ(name(257), "moving-other-vehicle");
  EXPECT_EQ(name(258), "moving-truck");
  for (uint16_t id = 0; id < 260; ++id) {
    const std::optional<Label> label = set.FromFileId(id);
    if (!label.has_value()) continue;
    EXPECT_EQ(set.HasRole(*label, LabelRole::kMoving), id >= 251) << id;
  }
  // The 19 classes, 7 moving ones, and unlabeled.
  EXPECT_EQ(set.size(), 27u);
}

TEST(SemanticKittiLabelsTest, DoNotRejectPairsOfDifferentLabelsOutright) {
  for (const char* name : {"semantic_kitti.lua", "nuscenes.lua"}) {
    const LabelSet set = LoadShipped(name);
    for (size_t i = 0; i < set.size(); ++i) {
      EXPECT_LT(set.DefaultCertainty(Label{static_cast<uint8_t>(i)}), 1.f) << set.Name(Label(i));
      EXPECT_GT(set.DefaultCertainty(Label{static_cast<uint8_t>(i)}), 0.5f) << set.Name(Label(i));
    }
  }
}

TEST(NuscenesLabelsTest, ListAllIdsAndGiveTheRoles) {
  const LabelSet set = LoadShipped("nuscenes.lua");
  for (uint16_t id = 0; id < 32; ++id) EXPECT_TRUE(set.FromFileId(id).has_value()) << id;
  EXPECT_FALSE(set.FromFileId(32).has_value());
  const auto has = [&](const char* name, LabelRole role) {
    const absl::StatusOr<Label> label = set.FromName(name);
    EXPECT_TRUE(label.ok()) << label.status();
    return label.ok() && set.HasRole(*label, role);
  };
  EXPECT_TRUE(has("noise", LabelRole::kUnlabeled));
  EXPECT_TRUE(has("vehicle.car", LabelRole::kMovable));
  EXPECT_FALSE(has("vehicle.car", LabelRole::kMoving));
  EXPECT_TRUE(has("movable_object.barrier", LabelRole::kMovable));
  EXPECT_TRUE(has("human.pedestrian.child", LabelRole::kMoving));
  EXPECT_TRUE(has("vehicle.ego", LabelRole::kMoving));
  EXPECT_FALSE(has("static.manmade", LabelRole::kMovable));
  EXPECT_THAT(NamesWithRole(set, LabelRole::kGround),
              UnorderedElementsAre("flat.driveable_surface", "flat.other", "flat.sidewalk",
                                   "flat.terrain"));
  EXPECT_EQ(set.Name(*set.FromName("vehicle.bus.bendy")), "vehicle.bus.rigid");
}

// CIE L*a*b* (D65): Euclidean distances in it follow what the eye tells apart; 2 is just visible.
struct Lab {
  double l, a, b;
};

Lab ToLab(const Color& color) {
  const auto linear = [](uint8_t value) {
    const double x = value / 255.;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  const double r = linear(color.red), g = linear(color.green), b = linear(color.blue);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16. / 116.; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
  const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
  return {116. * y - 16., 500. * (x - y), 200. * (y - z)};
}

double VisibleDistance(const Color& color_a, const Color& color_b) {
  const Lab a = ToLab(color_a), b = ToLab(color_b);
  return std::hypot(a.l - b.l, a.a - b.a, a.b - b.b);
}

TEST(SemanticKittiLabelsTest, ColourTheMainClassesFarApartOnALightBackground) {
  const LabelSet set = LoadShipped("semantic_kitti.lua");
  const std::vector<std::string> names = {"road",  "sidewalk", "building",  "car",
                                          "trunk", "pole",     "vegetation"};
  for (size_t i = 0; i < names.size(); ++i) {
    const Color color = set.ColorOf(*set.FromName(names[i]));
    EXPECT_GT(VisibleDistance(color, Color{255, 255, 255}), 40.) << names[i];
    for (size_t k = 0; k < i; ++k) {
      EXPECT_GT(VisibleDistance(color, set.ColorOf(*set.FromName(names[k]))), 35.)
          << names[i] << " and " << names[k];
    }
  }
}

TEST(SemanticKittiLabelsTest, SurviveTheRoundTripThroughLua) {
  const LabelSet set = LoadShipped("semantic_kitti.lua");
  proto::LabelSet read_back;
  const absl::Status status = common::LoadOptionsFromString(common::OptionsToLua(set.declaration()),
                                                            "resolved", {}, &read_back);
  ASSERT_TRUE(status.ok()) << status;
  EXPECT_EQ(read_back.SerializeAsString(), set.declaration().SerializeAsString());
}

std::string ReadFile(const std::string& path) {
  std::ifstream stream(path);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

TEST(SemanticKittiLabelsTest, GiveAnErrorOrASetWhenDamaged) {
  constexpr unsigned kSeed = 11;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const std::string lua = ReadFile(SourcePath("configuration_files/labels/semantic_kitti.lua"));
  int num_errors = 0;
  for (int i = 0; i < 400; ++i) {
    std::string damaged = lua.substr(0, i % 2 == 0 ? lua.size() : random() % lua.size());
    for (int k = 0; k < 3 && !damaged.empty(); ++k) {
      damaged[random() % damaged.size()] = static_cast<char>(random());
    }
    proto::LabelSet declaration;
    absl::Status status = common::LoadOptionsFromString(damaged, "damaged", {}, &declaration);
    if (!status.ok()) {
      EXPECT_THAT(std::string(status.message()), StartsWith("damaged:"));
    } else {
      status = LabelSet::Create(declaration).status();
    }
    EXPECT_EQ(status.message().find('\n'), absl::string_view::npos) << status;
    num_errors += !status.ok();
  }
  EXPECT_GT(num_errors, 250);  // the others damaged a comment or a colour
}

// The first block between ```lua and ``` of a Markdown file.
std::string FirstLuaBlock(const std::string& path) {
  const std::string text = ReadFile(path);
  const std::string opening = "```lua\n";
  const size_t begin = text.find(opening);
  if (begin == std::string::npos) return "";
  const size_t end = text.find("```", begin + opening.size());
  return text.substr(begin + opening.size(), end - begin - opening.size());
}

TEST(LabelsDocumentTest, ShowsALabelSetThatLoads) {
  const std::string lua = FirstLuaBlock(SourcePath("docs/labels.md"));
  ASSERT_FALSE(lua.empty());
  proto::LabelSet declaration;
  const absl::Status status =
      common::LoadOptionsFromString(lua, "docs/labels.md", {}, &declaration);
  ASSERT_TRUE(status.ok()) << status;
  const absl::StatusOr<LabelSet> set = LabelSet::Create(declaration);
  ASSERT_TRUE(set.ok()) << set.status();
  EXPECT_TRUE(set->HasRole(*set->FromName("traffic-light"), LabelRole::kCritical));
  EXPECT_EQ(*set->FromName("lane"), *set->FromName("road"));
  EXPECT_FLOAT_EQ(set->DefaultCertainty(*set->FromName("traffic-light")), 0.7f);
}

}  // namespace
}  // namespace cartographer::sensor
