// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/option_unit.h"

#include <gtest/gtest.h>

namespace semantic_kiss::manual {
namespace {

TEST(UnitOfTest, TakesTheLongestEnding) {
  EXPECT_EQ(UnitOf("max_range_m"), "m");
  EXPECT_EQ(UnitOf("linear_m_per_m"), "m per m");
  EXPECT_EQ(UnitOf("translation_weight_per_m"), "1/m");
  EXPECT_EQ(UnitOf("city_speed_m_per_s"), "m/s");
  EXPECT_EQ(UnitOf("lateral_acceleration_m_per_s2"), "m/s^2");
  EXPECT_EQ(UnitOf("angular_deg_per_m"), "deg per m");
  EXPECT_EQ(UnitOf("keep_deg"), "deg");
}

TEST(UnitOfTest, CountsAndSharesHaveNone) {
  EXPECT_EQ(UnitOf("max_iterations"), "");
  EXPECT_EQ(UnitOf("share"), "");
  EXPECT_EQ(UnitOf("m"), "") << "that is a name, not an ending";
  EXPECT_EQ(UnitOf(""), "");
}

}  // namespace
}  // namespace semantic_kiss::manual
