// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/label_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "test/semantic_kiss/simulation/small_drive.h"

namespace semantic_kiss::simulation {
namespace {

struct Tally {
  int points = 0, right = 0;
};

TEST(LabelNoiseTest, SharesAndCertaintiesAreHonest) {
  const auto exact = SmallDrive("options.route.length_m = 300.");
  std::map<int, SimulatedScan> truths;
  for (int scan = 0; scan < exact->num_scans(); scan += 4) truths[scan] = exact->Scan(scan);
  for (const double share : {0.03, 0.1, 0.25}) {
    SCOPED_TRACE(share);
    proto::LabelNoiseOptions options = exact->options().label_noise();
    options.set_share(share);
    Tally all;
    std::map<int, Tally> by_certainty;  // in steps of 0.05
    for (const auto& [scan, truth] : truths) {
      SimulatedScan noisy = truth;
      AddLabelNoise(options, 1, scan, &noisy);
      for (size_t i = 0; i < truth.size(); ++i) {
        for (Tally* tally : {&all, &by_certainty[std::lround(noisy[i].certainty / 0.05)]}) {
          ++tally->points;
          tally->right += noisy[i].label == truth[i].label;
        }
      }
    }
    EXPECT_NEAR(1. - static_cast<double>(all.right) / all.points, share, 0.25 * share);
    for (const auto& [step, tally] : by_certainty) {
      if (tally.points < 5000) continue;
      EXPECT_NEAR(static_cast<double>(tally.right) / tally.points, 0.05 * step, 0.05)
          << "certainty " << 0.05 * step << ", " << tally.points << " points";
    }
  }
}

TEST(LabelNoiseTest, ThingsAreMistakenAsAWhole) {
  const auto drive =
      SmallDrive("options.label_noise.share = 0.2 options.label_noise.border_factor = 0.");
  for (int scan = 0; scan < drive->num_scans(); scan += 15) {
    std::map<std::pair<uint32_t, int>, std::set<uint16_t>> said;  // of each pole, tree, car
    for (const SimulatedPoint& point : drive->Scan(scan)) {
      if (point.moving || point.primitive < 0) continue;
      const uint16_t truth = drive->world().primitives()[point.primitive].material.label;
      if (truth == label::kBuilding) continue;
      said[{point.object, truth}].insert(point.label);
    }
    for (const auto& [thing, labels] : said) EXPECT_EQ(labels.size(), 1u) << thing.first;
  }
}

TEST(LabelNoiseTest, WithoutNoiseNothingChanges) {
  const auto drive = SmallDrive();
  for (const SimulatedPoint& point : drive->Scan(4)) EXPECT_EQ(point.certainty, 1.f);
}

TEST(LabelNoiseTest, EmptyScanStaysEmpty) {
  SimulatedScan points;
  proto::LabelNoiseOptions options = SmallOptions().label_noise();
  options.set_share(0.1);
  AddLabelNoise(options, 1, 0, &points);
  EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace semantic_kiss::simulation
