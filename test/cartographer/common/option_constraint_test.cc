// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/option_constraint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cartographer/common/proto/options_loader_test.pb.h"

namespace cartographer::common {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const google::protobuf::FieldDescriptor& Field(const std::string& name) {
  return *proto::TestOptions::descriptor()->FindFieldByName(name);
}

TEST(RangeTest, BindsAtEachOfItsBounds) {
  proto::Range range;
  EXPECT_TRUE(Satisfies(range, -1e300));
  EXPECT_EQ(DescribeRange(range), "");
  range.set_above(0.);
  EXPECT_EQ(DescribeRange(range), "x > 0");
  EXPECT_FALSE(Satisfies(range, 0.));
  EXPECT_TRUE(Satisfies(range, 1e-300));
  range.set_at_most(0.5);
  EXPECT_EQ(DescribeRange(range), "0 < x <= 0.5");
  EXPECT_TRUE(Satisfies(range, 0.5));
  EXPECT_FALSE(Satisfies(range, 0.6));
  EXPECT_FALSE(Satisfies(range, std::nan("")));

  proto::Range other;
  other.set_below(1.);
  EXPECT_EQ(DescribeRange(other), "x < 1");
  EXPECT_FALSE(Satisfies(other, 1.));
  other.set_at_least(-1.);
  EXPECT_EQ(DescribeRange(other), "-1 <= x < 1");
  EXPECT_TRUE(Satisfies(other, -1.));
  EXPECT_FALSE(Satisfies(other, -1.1));
  EXPECT_FALSE(Satisfies(proto::Range(), std::nan("")));
  other.clear_below();
  EXPECT_EQ(DescribeRange(other), "x >= -1");
}

TEST(OptionConstraintTest, ReadsAnnotations) {
  EXPECT_FALSE(RangeOf(Field("title")).has_value());
  ASSERT_TRUE(RangeOf(Field("limit_m")).has_value());
  EXPECT_EQ(RangeOf(Field("limit_m"))->below(), 10.);
  EXPECT_THAT(WordsOf(Field("roles")), ElementsAre("moving", "ground"));
  EXPECT_THAT(WordsOf(Field("mode")), ElementsAre("TEST_MODE_LINEAR", "TEST_MODE_NEAREST"));
  EXPECT_THAT(WordsOf(Field("title")), IsEmpty());
}

TEST(OptionConstraintTest, DescribesWhatAFieldMustBe) {
  EXPECT_EQ(DescribeRequirement(Field("limit_m")), "a number with 0 <= x < 10");
  EXPECT_EQ(DescribeRequirement(Field("enabled")), "true or false");
  EXPECT_EQ(DescribeRequirement(Field("title")), "a string");
  EXPECT_EQ(DescribeRequirement(Field("blob")), "a string");
  EXPECT_EQ(DescribeRequirement(Field("icp")), "a table with named keys");
  EXPECT_EQ(DescribeRequirement(Field("weights")), "a table with named keys");
  EXPECT_EQ(DescribeRequirement(Field("color")), "a list, { ... }");
  EXPECT_EQ(DescribeRequirement(Field("entries")), "a list, { ... }");
  EXPECT_EQ(DescribeScalar(Field("color"), Field("color")), "an integer with 0 <= x <= 255");
  const auto& value = *Field("weights").message_type()->map_value();
  EXPECT_EQ(DescribeScalar(value, Field("weights")), "a number with 0 <= x <= 1");
}

}  // namespace
}  // namespace cartographer::common
