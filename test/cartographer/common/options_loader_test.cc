// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/options_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "absl/strings/str_replace.h"
#include "cartographer/common/proto/options_loader_test.pb.h"

namespace cartographer::common {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kValid[] = R"lua(
return {
  icp = { max_iterations = 500, gate_m = 2.5, kernel = "huber" },
  enabled = true,
  title = "a title",
  blob = "\x00\xff",
  mode = "TEST_MODE_NEAREST",
  color = { 0, 128, 255 },
  roles = { "ground" },
  entries = { { name = "first", weight = 0.5 }, { name = "second", weight = 1 } },
  weights = { car = 0.25, ["traffic-sign"] = 1 },
  named = { pole = { name = "a pole", weight = 0 } },
  numbers = { small = -1, large = -2, count = 3, seed = 4, single = 0.1, real = 0.1 },
}
)lua";

absl::Status Load(const std::string& source, proto::TestOptions* options) {
  return LoadOptionsFromString(source, "test.lua", {}, options);
}

// The error after replacing `from`, which must be there, by `to` in the valid file.
std::string ErrorAfter(const std::string& from, const std::string& to) {
  EXPECT_THAT(kValid, HasSubstr(from));
  proto::TestOptions options;
  const absl::Status status = Load(absl::StrReplaceAll(kValid, {{from, to}}), &options);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), Not(HasSubstr("\n")));
  return std::string(status.message());
}

TEST(LoadOptionsTest, FillsEveryKindOfField) {
  proto::TestOptions options;
  options.set_limit_m(5.);  // is cleared
  const absl::Status status = Load(kValid, &options);
  ASSERT_TRUE(status.ok()) << status;
  EXPECT_EQ(options.icp().max_iterations(), 500);
  EXPECT_EQ(options.icp().gate_m(), 2.5);
  EXPECT_EQ(options.icp().kernel(), "huber");
  EXPECT_TRUE(options.enabled());
  EXPECT_EQ(options.title(), "a title");
  EXPECT_EQ(options.blob(), std::string("\x00\xff", 2));
  EXPECT_EQ(options.mode(), proto::TEST_MODE_NEAREST);
  EXPECT_FALSE(options.has_limit_m());
  EXPECT_FALSE(options.has_extra());
  EXPECT_THAT(options.color(), ElementsAre(0, 128, 255));
  EXPECT_THAT(options.roles(), ElementsAre("ground"));
  ASSERT_EQ(options.entries_size(), 2);
  EXPECT_EQ(options.entries(1).name(), "second");
  EXPECT_EQ(options.entries(1).weight(), 1.);
  EXPECT_EQ(options.weights().size(), 2u);
  EXPECT_EQ(options.weights().at("traffic-sign"), 1.);
  EXPECT_EQ(options.named().at("pole").name(), "a pole");
  EXPECT_EQ(options.numbers().small(), -1);
  EXPECT_EQ(options.numbers().large(), -2);
  EXPECT_EQ(options.numbers().count(), 3u);
  EXPECT_EQ(options.numbers().seed(), 4u);
  EXPECT_EQ(options.numbers().single(), 0.1f);
  EXPECT_EQ(options.numbers().real(), 0.1);
  EXPECT_EQ(options.shape_case(), proto::TestOptions::SHAPE_NOT_SET);
}

TEST(LoadOptionsTest, AcceptsOptionalFieldsEmptyListsAndWholeFloats) {
  proto::TestOptions options;
  const absl::Status status =
      Load(absl::StrReplaceAll(kValid, {{"500", "5e2"},
                                        {"{ 0, 128, 255 }", "{}"},
                                        {"{ car = 0.25, [\"traffic-sign\"] = 1 }", "{}"},
                                        {"enabled", "limit_m = 0, radius_m = 1, enabled"}}),
           &options);
  ASSERT_TRUE(status.ok()) << status;
  EXPECT_EQ(options.icp().max_iterations(), 500);
  EXPECT_EQ(options.color_size(), 0);
  EXPECT_TRUE(options.weights().empty());
  EXPECT_TRUE(options.has_limit_m());
  EXPECT_EQ(options.radius_m(), 1.);
}

TEST(LoadOptionsTest, NamesUnknownKeysAndTheNearestOne) {
  EXPECT_EQ(ErrorAfter("enabled = true", "enabled = true, icpp = 1"),
            "test.lua: unknown key icpp; did you mean \"icp\"?");
  EXPECT_EQ(ErrorAfter("gate_m = 2.5", "gate_m = 2.5, [\"no word\"] = 1"),
            "test.lua: unknown key icp[\"no word\"]; known: \"gate_m\", \"kernel\", "
            "\"max_iterations\"");
  EXPECT_EQ(ErrorAfter("weight = 1 }", "weight = 1, wieght = 3 }"),
            "test.lua: unknown key entries[2].wieght; did you mean \"weight\"?");
}

TEST(LoadOptionsTest, NamesMissingKeysAndWhatTheyMustBe) {
  EXPECT_EQ(ErrorAfter("max_iterations = 500,", ""),
            "test.lua: missing key icp.max_iterations; must be an integer with 0 < x <= 500");
  EXPECT_EQ(ErrorAfter("enabled = true,", ""),
            "test.lua: missing key enabled; must be true or false");
  EXPECT_EQ(ErrorAfter("enabled = true,", "enabled = ture,"),
            "test.lua: missing key enabled; must be true or false");
  EXPECT_EQ(ErrorAfter("roles = { \"ground\" },", ""),
            "test.lua: missing key roles; must be a list, { ... }");
  EXPECT_EQ(ErrorAfter("named = { pole = { name = \"a pole\", weight = 0 } },", ""),
            "test.lua: missing key named; must be a table with named keys");
  EXPECT_EQ(ErrorAfter(", kernel = \"huber\"", ""),
            "test.lua: missing key icp.kernel; must be one of \"geman_mcclure\", \"huber\"");
  EXPECT_EQ(ErrorAfter("name = \"a pole\", ", ""),
            "test.lua: missing key named.pole.name; must be a string");
}

TEST(LoadOptionsTest, RejectsValuesOutOfRange) {
  EXPECT_EQ(ErrorAfter("500", "-3"),
            "test.lua: icp.max_iterations = -3; must satisfy 0 < x <= 500");
  EXPECT_EQ(ErrorAfter("500", "0"), "test.lua: icp.max_iterations = 0; must satisfy 0 < x <= 500");
  EXPECT_EQ(ErrorAfter("500", "501"),
            "test.lua: icp.max_iterations = 501; must satisfy 0 < x <= 500");
  EXPECT_EQ(ErrorAfter("2.5", "-0.5"), "test.lua: icp.gate_m = -0.5; must satisfy x > 0");
  EXPECT_EQ(ErrorAfter("enabled", "limit_m = 10, enabled"),
            "test.lua: limit_m = 10; must satisfy 0 <= x < 10");
  EXPECT_EQ(ErrorAfter("128", "256"), "test.lua: color[2] = 256; must satisfy 0 <= x <= 255");
  EXPECT_EQ(ErrorAfter("[\"traffic-sign\"] = 1", "[\"traffic-sign\"] = 2"),
            "test.lua: weights[\"traffic-sign\"] = 2; must satisfy 0 <= x <= 1");
}

TEST(LoadOptionsTest, RejectsNumbersThatDoNotFit) {
  EXPECT_EQ(ErrorAfter("small = -1", "small = 2147483648"),
            "test.lua: numbers.small = 2147483648; must satisfy -2147483648 <= x <= 2147483647");
  EXPECT_EQ(ErrorAfter("count = 3", "count = -1"),
            "test.lua: numbers.count = -1; must satisfy 0 <= x <= 4294967295");
  EXPECT_EQ(ErrorAfter("seed = 4", "seed = -1"),
            "test.lua: numbers.seed = -1; must satisfy 0 <= x <= 9223372036854775807");
  EXPECT_EQ(ErrorAfter("large = -2", "large = 2^63"),
            "test.lua: numbers.large = 9.223372036854776e+18; must be an integer");
  EXPECT_EQ(ErrorAfter("single = 0.1", "single = 1e39"),
            "test.lua: numbers.single = 1e+39; must satisfy |x| < 3.4e38, the range of a 32-bit "
            "float");
}

TEST(LoadOptionsTest, RejectsNumbersThatAreNone) {
  EXPECT_EQ(ErrorAfter("2.5", "0/0"), "test.lua: icp.gate_m = nan; must be a finite number");
  EXPECT_EQ(ErrorAfter("2.5", "math.huge"), "test.lua: icp.gate_m = inf; must be a finite number");
  EXPECT_EQ(ErrorAfter("500", "-math.huge"),
            "test.lua: icp.max_iterations = -inf; must be an integer with 0 < x <= 500");
}

TEST(LoadOptionsTest, RejectsMistypedValues) {
  EXPECT_EQ(ErrorAfter("500", "1.5"),
            "test.lua: icp.max_iterations = 1.5; must be an integer with 0 < x <= 500");
  EXPECT_EQ(ErrorAfter("500", "\"500\""),
            "test.lua: icp.max_iterations = \"500\"; must be an integer with 0 < x <= 500");
  EXPECT_EQ(ErrorAfter("2.5", "true"), "test.lua: icp.gate_m = true; must be a number with x > 0");
  EXPECT_EQ(ErrorAfter("= true", "= \"true\""),
            "test.lua: enabled = \"true\"; must be true or false");
  EXPECT_EQ(ErrorAfter("= true", "= 1"), "test.lua: enabled = 1; must be true or false");
  EXPECT_EQ(ErrorAfter("\"a title\"", "7"), "test.lua: title = 7; must be a string");
  EXPECT_EQ(ErrorAfter("\"a title\"", "print"), "test.lua: missing key title; must be a string");
  EXPECT_EQ(ErrorAfter("\"a title\"", "include"), "test.lua: title = a function; must be a string");
  EXPECT_EQ(ErrorAfter("\"a title\"", "\"\\xff\""),
            "test.lua: title = \"\xff\"; must be UTF-8; save the file in that encoding");
  EXPECT_EQ(ErrorAfter("{ 0, 128, 255 }", "7"), "test.lua: color = 7; must be a list, { ... }");
  EXPECT_EQ(ErrorAfter("{ 0, 128, 255 }", "{ r = 1 }"),
            "test.lua: color = a table with named keys; must be a list, { ... }");
  EXPECT_EQ(ErrorAfter("0, 128", "{}, 128"),
            "test.lua: color[1] = an empty table; must be an integer with 0 <= x <= 255");
  EXPECT_EQ(ErrorAfter("{ name = \"first\", weight = 0.5 }", "\"first\""),
            "test.lua: entries[1] = \"first\"; must be a table with named keys");
  EXPECT_EQ(ErrorAfter("{ car = 0.25, [\"traffic-sign\"] = 1 }", "{ 1, 2, 3 }"),
            "test.lua: weights = a list of 3; must be a table with named keys");
  EXPECT_EQ(ErrorAfter("{ name = \"a pole\", weight = 0 }", "1"),
            "test.lua: named.pole = 1; must be a table with named keys");
}

TEST(LoadOptionsTest, RejectsTablesThatAreNeitherListNorNamed) {
  EXPECT_EQ(ErrorAfter("{ 0, 128, 255 }", "{ 0, 128, b = 255 }"),
            "test.lua: color = a table with both list entries and named keys; must be a list, "
            "{ ... }");
  EXPECT_EQ(ErrorAfter("{ 0, 128, 255 }", "{ 0, nil, 255 }"),
            "test.lua: color = a list without entry 2; must be a list, { ... }");
  EXPECT_EQ(ErrorAfter("{ 0, 128, 255 }", "{ [0] = 1 }"),
            "test.lua: color = a list with index 0; must be a list, { ... }");
  EXPECT_EQ(ErrorAfter("{ 0, 128, 255 }", "{ [1.5] = 1 }"),
            "test.lua: color = a table with keys that are neither strings nor list indices; must "
            "be a list, { ... }");
  EXPECT_EQ(ErrorAfter("return {", "return { 7,"),
            "test.lua: returned a table with both list entries and named keys; must be a table "
            "with named keys");
}

TEST(LoadOptionsTest, RejectsWordsThatAreNotAllowed) {
  EXPECT_EQ(ErrorAfter("huber", "hubr"),
            "test.lua: icp.kernel = \"hubr\"; must be one of \"geman_mcclure\", \"huber\"; did you "
            "mean \"huber\"?");
  EXPECT_EQ(ErrorAfter("\"ground\"", "\"ground\", \"x\""),
            "test.lua: roles[2] = \"x\"; must be one of \"moving\", \"ground\"");
  EXPECT_EQ(ErrorAfter("TEST_MODE_NEAREST", "cubic"),
            "test.lua: mode = \"cubic\"; must be one of \"TEST_MODE_LINEAR\", "
            "\"TEST_MODE_NEAREST\"");
  EXPECT_EQ(ErrorAfter("\"TEST_MODE_NEAREST\"", "1"),
            "test.lua: mode = 1; must be one of \"TEST_MODE_LINEAR\", \"TEST_MODE_NEAREST\"");
}

TEST(LoadOptionsTest, RejectsTwoMembersOfAOneof) {
  EXPECT_EQ(ErrorAfter("enabled", "side_m = 1, radius_m = 2, enabled"),
            "test.lua: radius_m and side_m exclude each other; give only one");
}

TEST(LoadOptionsTest, ReportsTheFirstErrorAndCountsTheOthers) {
  EXPECT_EQ(ErrorAfter("max_iterations", "max_iteration"),
            "test.lua: unknown key icp.max_iteration; did you mean \"max_iterations\"? (and 1 more "
            "error)");
  EXPECT_EQ(ErrorAfter("enabled = true", "zzz = 1, aaaa = 2"),
            "test.lua: unknown key aaaa; known: \"icp\", \"blob\", \"mode\", \"extra\", \"named\", "
            "\"title\", \"color\", \"roles\", ... (and 2 more errors)");
}

TEST(LoadOptionsTest, NamesTheFileInLuaErrorsToo) {
  proto::TestOptions options;
  EXPECT_THAT(std::string(Load("return {\n  icp = = 3\n}", &options).message()),
              HasSubstr("test.lua:2: unexpected symbol near '='"));
  EXPECT_EQ(Load("x = 1", &options).message(),
            "test.lua: returned nothing; must end with `return` and a table: return { ... }");
}

TEST(LoadOptionsDeathTest, RefusesMapsWithOtherKeys) {
  proto::TestBadMapOptions options;
  EXPECT_DEATH(static_cast<void>(
                   LoadOptionsFromString("return { by_number = {} }", "test.lua", {}, &options)),
               "by_number: options can only be maps with string keys");
}

}  // namespace
}  // namespace cartographer::common
