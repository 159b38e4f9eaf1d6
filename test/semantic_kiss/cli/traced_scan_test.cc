// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/traced_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace semantic_kiss::cli {
namespace {

using ::testing::HasSubstr;

TEST(TracedScanTest, ReadsTheFlag) {
  EXPECT_TRUE(ScansToTrace("")->empty());
  EXPECT_EQ(*ScansToTrace("450, 120,450"), (std::set<int>{120, 450}));
  const auto bad = ScansToTrace("120,all").status();
  EXPECT_THAT(std::string(bad.message()), HasSubstr("--trace_scan"));
  EXPECT_THAT(std::string(bad.message()), HasSubstr("`all`"));
}

TEST(TracedScanTest, ScansMustBeAmongTheDriven) {
  EXPECT_TRUE(CheckScansToTrace({}, 0, 0).ok());
  EXPECT_TRUE(CheckScansToTrace({10, 19}, 10, 10).ok());
  for (const int number : {9, 20, -1}) {
    const absl::Status status = CheckScansToTrace({12, number}, 10, 10);
    EXPECT_THAT(std::string(status.message()), HasSubstr("from 10 to 19")) << number;
  }
}

}  // namespace
}  // namespace semantic_kiss::cli
