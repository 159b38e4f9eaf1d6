// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/relocalizer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cartographer/transform/se3.h"
#include "test/cartographer/slam/street_localization.h"

namespace cartographer::slam {
namespace {

using transform::Rigid3d;
using State = LocalizationState;

constexpr double kDeg = M_PI / 180.;
constexpr double kRightWithin_m = 0.3;

// From one end of what is mapped to the other, against the direction in which it was mapped.
StreetVisit Visit() {
  StreetVisit visit;
  DriveOn(15., 2., /*forwards=*/false, /*meters=*/30, &visit);
  return visit;
}

double Error_m(const StreetVisit& visit, int scan, const Rigid3d& map_from_sensor) {
  return (visit.truth[scan].translation() - map_from_sensor.translation()).norm();
}

// Whenever a pose is given it is the true one, and it is given exactly while localized.
void ExpectTheTruthOrNothing(const StreetVisit& visit, const Localized& localized, int from = 0) {
  ASSERT_EQ(localized.scans.size(), visit.truth.size());
  ASSERT_EQ(localized.smoothed.size(), visit.truth.size());
  for (size_t i = from; i < localized.scans.size(); ++i) {
    const LocalizedScan& scan = localized.scans[i];
    ASSERT_EQ(scan.map_from_sensor.has_value(), scan.state == State::kLocalized) << i;
    EXPECT_EQ(scan.outcome, "scripted");
    if (scan.map_from_sensor.has_value()) {
      EXPECT_TRUE(scan.reason.empty()) << i << " " << scan.reason;
      EXPECT_LT(Error_m(visit, i, *scan.map_from_sensor), kRightWithin_m) << i;
      EXPECT_LT(transform::RotationAngle(visit.truth[i].inverse() * *scan.map_from_sensor),
                1. * kDeg)
          << i;
      EXPECT_GT(scan.score, 0.7) << i;
    }
    if (localized.smoothed[i].has_value()) {
      EXPECT_LT(Error_m(visit, i, *localized.smoothed[i]), kRightWithin_m) << i;
    }
  }
}

int NumSmoothed(const Localized& localized) {
  int num = 0;
  for (const auto& pose : localized.smoothed) num += pose.has_value() ? 1 : 0;
  return num;
}

// The visit from an unknown start, with everything as shipped.
const Localized& PlainVisit() {
  static const Localized& localized = *new Localized(Localize(MapOfStreet(), Visit()));
  return localized;
}

TEST(RelocalizerTest, FindsAnUnknownStartAndFollowsTheDrive) {
  const Localized& localized = PlainVisit();
  ExpectTheTruthOrNothing(Visit(), localized);
  // The first submap takes 12 nodes, before which no place can be recognized.
  EXPECT_EQ(localized.scans[0].state, State::kSearching);
  EXPECT_EQ(localized.scans[0].map_from_sensor, std::nullopt);
  const int fix = localized.FirstWith(State::kLocalized);
  ASSERT_GE(fix, 22);
  ASSERT_LT(fix, 45);
  for (size_t i = fix; i < localized.scans.size(); ++i) {
    EXPECT_EQ(localized.scans[i].state, State::kLocalized) << i;
    // Nodes are searched for every 3 m, and nearly all of them are found.
    EXPECT_LE(localized.scans[i].since_match_m, 7.) << i;
  }
  EXPECT_EQ(localized.num_odometries, 1);
  // In the end it is known where the scans before the fix were, too.
  EXPECT_EQ(NumSmoothed(localized), 60);
}

TEST(RelocalizerTest, AGuessMakesItFaster) {
  const StreetVisit visit = Visit();
  const Localized localized = Localize(MapOfStreet(), visit, "", [](Relocalizer* relocalizer) {
    relocalizer->StartNear({16.5, 0.7}, M_PI + 4. * kDeg);
  });
  ExpectTheTruthOrNothing(visit, localized);
  const int fix = localized.FirstWith(State::kLocalized);
  // The second node that is searched for, 3 m later, agrees with the first.
  EXPECT_GE(fix, 6);
  EXPECT_LE(fix, 12);
  EXPECT_EQ(NumSmoothed(localized), 60);
}

TEST(RelocalizerTest, AWrongGuessIsNotBelieved) {
  const StreetVisit visit = Visit();
  const Localized localized = Localize(MapOfStreet(), visit, "", [](Relocalizer* relocalizer) {
    relocalizer->StartNear({-14., -2.}, 0.);
  });
  ExpectTheTruthOrNothing(visit, localized);
  // What the place looks like tells otherwise, as soon as there is a submap.
  const int fix = localized.FirstWith(State::kLocalized);
  EXPECT_GE(fix, 22);
  EXPECT_LT(fix, 45);
}

TEST(RelocalizerTest, AnotherPlaceIsNeverFound) {
  StreetVisit visit = Visit();
  visit.street = 7;
  const Localized localized = Localize(MapOfStreet(), visit);
  for (const LocalizedScan& scan : localized.scans) EXPECT_EQ(scan.state, State::kSearching);
  EXPECT_TRUE(localized.scans.front().reason.empty());  // nothing was searched for yet
  EXPECT_FALSE(localized.scans.back().reason.empty());
  EXPECT_EQ(NumSmoothed(localized), 0);
}

TEST(RelocalizerTest, KidnappedItIsLostAndFoundAgain) {
  // Half of the way, and suddenly it's at the other end, heading back; the odometry notices
  // nothing.
  StreetVisit visit;
  DriveOn(-15., 0., /*forwards=*/true, /*meters=*/20, &visit);
  const int jump = visit.truth.size();
  DriveOn(15., 2., /*forwards=*/false, /*meters=*/28, &visit);
  const Localized localized = Localize(MapOfStreet(), visit, "RELOCALIZATION.lost_after_nodes = 2");
  ASSERT_EQ(localized.scans[jump - 1].state, State::kLocalized);

  const int lost = localized.FirstWith(State::kLost);
  ASSERT_GT(lost, jump);
  EXPECT_LE(lost, jump + 16);  // two nodes, 3 m apart, and what is missing to the first
  EXPECT_FALSE(localized.scans[lost].reason.empty());
  EXPECT_EQ(localized.scans[lost].map_from_sensor, std::nullopt);
  EXPECT_EQ(localized.num_odometries, 2);

  const int found = localized.FirstWith(State::kLocalized, lost);
  ASSERT_GT(found, lost);
  ExpectTheTruthOrNothing(visit, localized, lost);
  for (int i = lost + 1; i < found; ++i) EXPECT_NE(localized.scans[i].state, State::kLocalized);
  // A new submap is looked for anew before that: lost, searching, localized. The last may come
  // with the same scan.
  EXPECT_EQ(localized.scans.back().state, State::kLocalized);
  // Between the last match and the loss no pose is to be trusted, in hindsight either.
  for (int i = 0; i < jump - 8; ++i) EXPECT_TRUE(localized.smoothed[i].has_value()) << i;
  for (int i = jump; i <= lost; ++i) EXPECT_FALSE(localized.smoothed[i].has_value()) << i;
  for (size_t i = lost + 1; i < localized.smoothed.size(); ++i) {
    EXPECT_TRUE(localized.smoothed[i].has_value()) << i;
  }
}

TEST(RelocalizerTest, LosesPatienceAfterAsManyNodesAsTold) {
  StreetVisit visit;
  DriveOn(-15., 0., true, 40, &visit);
  constexpr int kBlindFrom = 50;
  visit.blind = [](int scan) { return scan >= kBlindFrom; };
  int lost[2];
  for (const int nodes : {1, 4}) {
    const Localized localized = Localize(
        MapOfStreet(), visit, "RELOCALIZATION.lost_after_nodes = " + std::to_string(nodes));
    ASSERT_EQ(localized.scans[kBlindFrom - 1].state, State::kLocalized);
    lost[nodes / 4] = localized.FirstWith(State::kLost);
  }
  EXPECT_GE(lost[0], kBlindFrom);
  EXPECT_LT(lost[0], kBlindFrom + 6);   // with the first node that sees nothing
  EXPECT_EQ(lost[1], lost[0] + 3 * 6);  // a node every 3 m, two scans a metre
}

TEST(RelocalizerTest, AFewEmptyScansAreDrivenThrough) {
  StreetVisit visit = Visit();
  // At the start, and for 3 m in the middle.
  visit.blind = [](int scan) { return scan < 2 || (scan >= 46 && scan < 52); };
  const Localized localized = Localize(MapOfStreet(), visit);
  ExpectTheTruthOrNothing(visit, localized);
  ASSERT_EQ(localized.scans[45].state, State::kLocalized);
  EXPECT_EQ(localized.FirstWith(State::kLost), -1);
  EXPECT_EQ(NumSmoothed(localized), 60);
}

TEST(RelocalizerTest, WhoSeesNothingIsNowhere) {
  StreetVisit visit = Visit();
  visit.blind = [](int) { return true; };
  const Localized localized = Localize(MapOfStreet(), visit);
  EXPECT_EQ(localized.FirstWith(State::kLocalized), -1);
  EXPECT_EQ(NumSmoothed(localized), 0);
}

TEST(RelocalizerTest, AnEmptyMapHasNoPlaces) {
  map::Map map;
  map.labels = MapOfStreet().labels;
  const StreetVisit visit = Visit();
  const Localized localized = Localize(map, visit, "", [](Relocalizer* relocalizer) {
    relocalizer->StartNear({0., 0.}, 0.);
  });
  for (const LocalizedScan& scan : localized.scans) EXPECT_EQ(scan.state, State::kSearching);
  EXPECT_EQ(localized.scans.back().reason, "no_candidate");
  EXPECT_EQ(NumSmoothed(localized), 0);
}

TEST(RelocalizerTest, NoScansNoPoses) { EXPECT_TRUE(Localize(MapOfStreet(), {}).smoothed.empty()); }

TEST(RelocalizerTest, WhatIsForgottenKeepsItsPose) {
  const StreetVisit visit = Visit();
  const Localized trimmed = Localize(MapOfStreet(), visit, "RELOCALIZATION.keep_m = 10");
  ExpectTheTruthOrNothing(visit, trimmed);
  EXPECT_EQ(NumSmoothed(trimmed), 60);
  // 10 m at least are kept of 30, a node each.
  EXPECT_LT(trimmed.num_nodes, PlainVisit().num_nodes - 5);
  // What came later moved the first scan no more.
  EXPECT_NE(trimmed.smoothed[0]->translation(), PlainVisit().smoothed[0]->translation());
}

TEST(RelocalizerDeathTest, TheStartIsToldBeforehand) {
  const StreetVisit visit = Visit();
  Relocalizer* told = nullptr;
  EXPECT_DEATH(
      {
        Localize(MapOfStreet(), visit, "", [&](Relocalizer* relocalizer) {
          told = relocalizer;
          sensor::LabeledScan scan;
          scan.time = common::FromUnixSeconds(1.);
          told->AddScan(scan);
          told->StartNear({0., 0.}, 0.);
        });
      },
      "smoothed_");
}

TEST(RelocalizerTest, StatesHaveNames) {
  EXPECT_EQ(StateName(State::kSearching), "searching");
  EXPECT_EQ(StateName(State::kLocalized), "localized");
  EXPECT_EQ(StateName(State::kLost), "lost");
}

}  // namespace
}  // namespace cartographer::slam
