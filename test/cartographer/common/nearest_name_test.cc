// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/nearest_name.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace cartographer::common {
namespace {

TEST(EditDistanceTest, HandlesEmptyEqualAndDisjointWords) {
  EXPECT_EQ(EditDistance("", ""), 0);
  EXPECT_EQ(EditDistance("", "car"), 3);
  EXPECT_EQ(EditDistance("car", ""), 3);
  EXPECT_EQ(EditDistance("car", "car"), 0);
  EXPECT_EQ(EditDistance("car", "dog"), 3);
}

TEST(EditDistanceTest, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(EditDistance("datset", "dataset"), 1);
  EXPECT_EQ(EditDistance("dataset", "datset"), 1);
  EXPECT_EQ(EditDistance("trunk", "truck"), 1);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
}

TEST(EditDistanceTest, CountsSwapsOfNeighboursAndIgnoresCase) {
  EXPECT_EQ(EditDistance("rnage", "range"), 1);
  EXPECT_EQ(EditDistance("Car", "car"), 0);
  EXPECT_EQ(EditDistance("abc", "cba"), 2);
}

// The definition, without a table: what to do with the first characters, then with the rest.
int EditDistanceByDefinition(absl::string_view a, absl::string_view b) {
  if (a.empty() || b.empty()) return static_cast<int>(a.size() + b.size());
  const int same = a[0] == b[0] ? 0 : 1;
  int best = EditDistanceByDefinition(a.substr(1), b.substr(1)) + same;
  best = std::min(best, EditDistanceByDefinition(a.substr(1), b) + 1);
  best = std::min(best, EditDistanceByDefinition(a, b.substr(1)) + 1);
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0]) {
    best = std::min(best, EditDistanceByDefinition(a.substr(2), b.substr(2)) + 1);
  }
  return best;
}

TEST(EditDistanceTest, AgreesWithTheDefinition) {
  constexpr unsigned kSeed = 3;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  const auto word = [&] {
    std::string text;
    for (unsigned left = random() % 7; left > 0; --left) text += "abc"[random() % 3];
    return text;
  };
  for (int i = 0; i < 300; ++i) {
    const std::string a = word(), b = word();
    EXPECT_EQ(EditDistance(a, b), EditDistanceByDefinition(a, b)) << a << " " << b;
  }
}

TEST(NearestNamesTest, ListsTheNearestFirst) {
  const std::vector<std::string> known = {"road", "traffic-sign", "car", "cart"};
  EXPECT_EQ(NearestNames("cat", known, 2), (std::vector<std::string>{"car", "cart"}));
  EXPECT_EQ(NearestNames("sign", known, 1), std::vector<std::string>{"traffic-sign"});
  EXPECT_EQ(NearestNames("cat", known, 9).size(), 4u);
  EXPECT_TRUE(NearestNames("cat", {}, 3).empty());
}

TEST(SuggestNameTest, AsksAboutSlipsAndListsOtherwise) {
  const std::vector<std::string> known = {"building", "pole", "car"};
  EXPECT_EQ(SuggestName("biulding", known), "did you mean \"building\"?");
  EXPECT_EQ(SuggestName("build", known), "did you mean \"building\"?");
  EXPECT_EQ(SuggestName("street", known), "known: \"pole\", \"car\", \"building\"");
  EXPECT_EQ(SuggestName("x", {}), "none is known here");
  EXPECT_EQ(SuggestName(std::string(100000, 'x'), {"a"}), "known: \"a\"");
  EXPECT_EQ(SuggestName("zzzzz", std::vector<std::string>(9, "a")),
            "known: \"a\", \"a\", \"a\", \"a\", \"a\", \"a\", \"a\", \"a\", ...");
}

TEST(NearestNameTest, PicksTheNearestAndTheFirstOfEquals) {
  EXPECT_EQ(NearestName("max_rang", {"min_range", "max_range"}), "max_range");
  EXPECT_EQ(NearestName("c", {"a", "b"}), "a");
  EXPECT_EQ(NearestName("anything", {}), "");
}

}  // namespace
}  // namespace cartographer::common
