// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/epoch.h"

#include <gtest/gtest.h>

namespace semantic_kiss::simulation {
namespace {

bool Same(const Tenant& a, const Tenant& b) {
  if (!a.present || !b.present) return a.present == b.present;
  return a.variant == b.variant && a.shift_m == b.shift_m && a.turn_rad == b.turn_rad;
}

TEST(EpochTest, MostParkedVehiclesDifferOnAnotherDay) {
  constexpr int kPlaces = 20000;
  int present = 0, changed = 0, left = 0, shifted = 0, present_next = 0;
  for (uint32_t place = 0; place < kPlaces; ++place) {
    const Tenant first = TenantOf(1, place, 0, 0.6, 0.6);
    const Tenant next = TenantOf(1, place, 3, 0.6, 0.6);
    present_next += next.present;
    if (!first.present) continue;
    ++present;
    changed += !Same(first, next);
    left += !next.present;
    shifted += next.present && next.variant == first.variant && next.shift_m != first.shift_m;
  }
  EXPECT_NEAR(static_cast<double>(changed) / present, 0.6, 0.02);
  EXPECT_NEAR(static_cast<double>(left) / present, 0.24, 0.02);
  EXPECT_NEAR(static_cast<double>(shifted) / present, 0.15, 0.02);
  EXPECT_NEAR(static_cast<double>(present_next) / kPlaces, 0.6, 0.02);
}

TEST(EpochTest, WithoutChangeEveryDayIsTheFirst) {
  for (uint32_t place = 0; place < 100; ++place) {
    EXPECT_TRUE(Same(TenantOf(1, place, 0, 0.5, 0.), TenantOf(1, place, 7, 0.5, 0.)));
  }
}

TEST(EpochTest, ShiftsAreSeen) {
  for (uint32_t place = 0; place < 2000; ++place) {
    const Tenant first = TenantOf(2, place, 0, 1., 1.);
    const Tenant next = TenantOf(2, place, 1, 1., 1.);
    if (!next.present || next.variant != first.variant) continue;
    EXPECT_GE(std::abs(next.shift_m - first.shift_m), 0.3);
    EXPECT_LE(std::abs(next.shift_m - first.shift_m), 0.7);
  }
}

}  // namespace
}  // namespace semantic_kiss::simulation
