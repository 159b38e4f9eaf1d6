// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/floor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace semantic_kiss::simulation {
namespace {

TEST(FloorTest, AgreesWithTheLibrary) {
  for (const double value : {0., -0., 0.5, -0.5, 1., -1., 0.999999, -1.000001, 3e9, -3e9 - 0.25}) {
    EXPECT_EQ(static_cast<double>(Floor(value)), std::floor(value)) << value;
  }
}

}  // namespace
}  // namespace semantic_kiss::simulation
