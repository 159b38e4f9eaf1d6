// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "cartographer/common/options_loader.h"
#include "cartographer/common/proto/options_loader_test.pb.h"
#include "google/protobuf/util/message_differencer.h"

namespace cartographer::common {
namespace {

using ::testing::HasSubstr;

proto::TestOptions ValidOptions() {
  proto::TestOptions options;
  options.mutable_icp()->set_max_iterations(7);
  options.mutable_icp()->set_gate_m(0.1);
  options.mutable_icp()->set_kernel("huber");
  options.mutable_numbers();
  return options;
}

// Compares bytes too, so that -0 differs from 0.
void ExpectRoundTrip(const proto::TestOptions& options) {
  const std::string lua = OptionsToLua(options);
  proto::TestOptions read_back;
  const absl::Status status = LoadOptionsFromString(lua, "written.lua", {}, &read_back);
  ASSERT_TRUE(status.ok()) << status << "\n" << lua;
  EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(options, read_back)) << lua;
  EXPECT_EQ(OptionsToLua(read_back), lua);
  EXPECT_EQ(options.numbers().SerializeAsString(), read_back.numbers().SerializeAsString()) << lua;
}

TEST(OptionsToLuaTest, WritesReadableLuaInFieldOrder) {
  proto::TestOptions options = ValidOptions();
  options.set_title("say \"hi\"\\\n");
  options.set_blob(std::string("\x00\x1f!", 3));
  options.add_color(1);
  options.add_color(2);
  options.add_entries()->set_name("only");
  (*options.mutable_weights())["traffic-sign"] = 0.5;
  (*options.mutable_weights())["end"] = 1.;
  (*options.mutable_weights())["car"] = 0.25;
  options.set_radius_m(1e6);
  EXPECT_EQ(OptionsToLua(options), R"lua(return {
  icp = {
    max_iterations = 7,
    gate_m = 0.1,
    kernel = "huber",
  },
  enabled = false,
  title = "say \"hi\"\\\n",
  blob = "\000\031!",
  mode = "TEST_MODE_LINEAR",
  color = { 1, 2 },
  roles = {},
  entries = {
    { name = "only", weight = 0 },
  },
  weights = {
    car = 0.25,
    ["end"] = 1,
    ["traffic-sign"] = 0.5,
  },
  named = {},
  radius_m = 1e+06,
  numbers = {
    small = 0,
    large = 0,
    count = 0,
    seed = 0,
    single = 0,
    real = 0,
  },
}
)lua");
  ExpectRoundTrip(options);
}

TEST(OptionToLuaTest, WritesOneFieldOnOneLine) {
  proto::TestOptions options = ValidOptions();
  const auto field = [&](const char* name) -> const google::protobuf::FieldDescriptor& {
    return *options.GetDescriptor()->FindFieldByName(name);
  };
  EXPECT_EQ(OptionToLua(options, field("roles")), "{}");
  options.set_title(std::string(120, 'x'));
  EXPECT_EQ(OptionToLua(options, field("title")), "\"" + std::string(120, 'x') + "\"");
  options.add_color(1);
  options.add_color(2);
  EXPECT_EQ(OptionToLua(options, field("color")), "{ 1, 2 }");
  options.add_entries()->set_name("only");
  EXPECT_EQ(OptionToLua(options, field("entries")), "{ { name = \"only\", weight = 0 } }");
}

TEST(OptionsToLuaTest, BreaksLinesThatGetTooLong) {
  proto::TestOptions options = ValidOptions();
  options.add_entries()->set_name(std::string(120, 'x'));
  EXPECT_THAT(OptionsToLua(options), HasSubstr("    {\n      name = \"xxx"));
  ExpectRoundTrip(options);
}

TEST(OptionsToLuaTest, KeepsOptionalFieldsApartFromDefaults) {
  proto::TestOptions options = ValidOptions();
  ExpectRoundTrip(options);
  options.set_limit_m(0.);
  options.mutable_extra();
  (*options.mutable_named())["a b"].set_name("umlaut: \xc3\xa4");
  options.set_side_m(0.);
  ExpectRoundTrip(options);
}

TEST(OptionsToLuaTest, KeepsTheExtremesOfEveryType) {
  proto::TestOptions options = ValidOptions();
  auto& numbers = *options.mutable_numbers();
  numbers.set_small(std::numeric_limits<int32_t>::min());
  numbers.set_large(std::numeric_limits<int64_t>::max());
  numbers.set_count(std::numeric_limits<uint32_t>::max());
  numbers.set_seed(static_cast<uint64_t>(std::numeric_limits<int64_t>::max()));
  for (const double real : {-0., DBL_MAX, -DBL_MAX, DBL_MIN, DBL_TRUE_MIN, 1. / 3., 0.1, 1e15, 1e17,
                            9007199254740993., 123456789012345678., -9223372036854775808.}) {
    numbers.set_real(real);
    ExpectRoundTrip(options);
  }
  for (const float single : {-0.f, FLT_MAX, -FLT_MAX, FLT_MIN, FLT_TRUE_MIN, 1.f / 3.f, 0.1f}) {
    numbers.set_single(single);
    ExpectRoundTrip(options);
  }
}

TEST(OptionsToLuaTest, KeepsRandomNumbersToTheLastBit) {
  constexpr uint64_t kSeed = 42;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  proto::TestOptions options = ValidOptions();
  for (int i = 0; i < 2000; ++i) {
    const uint64_t bits = random();
    double real;
    float single;
    std::memcpy(&real, &bits, sizeof(real));
    std::memcpy(&single, &bits, sizeof(single));
    if (!std::isfinite(real) || !std::isfinite(single)) continue;
    options.mutable_numbers()->set_real(real);
    options.mutable_numbers()->set_single(single);
    options.mutable_numbers()->set_large(static_cast<int64_t>(bits));
    ExpectRoundTrip(options);
  }
}

}  // namespace
}  // namespace cartographer::common
