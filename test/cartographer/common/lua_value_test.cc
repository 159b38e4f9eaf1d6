// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_value.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace cartographer::common {
namespace {

LuaValue Text(const std::string& text) {
  LuaValue value;
  value.kind = LuaValue::Kind::kString;
  value.text = text;
  return value;
}

LuaValue Number(double number) {
  LuaValue value;
  value.kind = LuaValue::Kind::kNumber;
  value.number = number;
  return value;
}

TEST(LuaValueTest, FindsEntriesOfATable) {
  LuaValue table;
  table.kind = LuaValue::Kind::kTable;
  EXPECT_EQ(table.Find("a"), nullptr);
  EXPECT_TRUE(table.IsEmptyTable());
  table.named = {{"a", Text("1")}, {"b", Text("2")}, {"d", Text("3")}};
  EXPECT_FALSE(table.IsEmptyTable());
  EXPECT_EQ(table.Find("b")->text, "2");
  EXPECT_EQ(table.Find("d")->text, "3");
  EXPECT_EQ(table.Find("c"), nullptr);
  EXPECT_EQ(table.Find("e"), nullptr);
  EXPECT_EQ(table.Find(""), nullptr);
}

TEST(LuaValueTest, DescribesValuesOnOneBoundedLine) {
  EXPECT_EQ(Describe(Text("a\nb")), "\"a\\nb\"");
  EXPECT_EQ(Describe(Text(std::string(1000, 'x'))), "\"" + std::string(60, 'x') + "\"...");
  EXPECT_EQ(Describe(Number(5.)), "5.0");
  EXPECT_EQ(Describe(Number(-0.25)), "-0.25");
  EXPECT_EQ(Describe(Number(1e100)), "1e+100");
  EXPECT_EQ(Describe(Number(-std::numeric_limits<double>::infinity())), "-inf");
  EXPECT_EQ(Describe(LuaValue()), "");
}

TEST(LuaNumberLiteralTest, WritesAsFewDigitsAsItTakes) {
  EXPECT_EQ(LuaNumberLiteral(0.1), "0.1");
  EXPECT_EQ(LuaNumberLiteral(0.1f), "0.1");
  EXPECT_EQ(LuaNumberLiteral(static_cast<double>(0.1f)), "0.10000000149011612");
  EXPECT_EQ(LuaNumberLiteral(100000.), "100000");
  EXPECT_EQ(LuaNumberLiteral(1. / 3.), "0.3333333333333333");
  EXPECT_EQ(LuaNumberLiteral(-0.), "-0.0");
  EXPECT_EQ(LuaNumberLiteral(0.), "0");
  EXPECT_EQ(LuaNumberLiteral(std::numeric_limits<double>::quiet_NaN()), "(0/0)");
  EXPECT_EQ(LuaNumberLiteral(-std::numeric_limits<float>::infinity()), "-math.huge");
}

TEST(LuaStringLiteralTest, EscapesWhatDoesNotPrint) {
  EXPECT_EQ(LuaStringLiteral(""), "\"\"");
  EXPECT_EQ(LuaStringLiteral("\"\\"), "\"\\\"\\\\\"");
  // Three digits, or the 1 would be taken for one of them.
  EXPECT_EQ(LuaStringLiteral(absl::string_view("\0001\x7f", 3)), "\"\\0001\\127\"");
  EXPECT_EQ(LuaStringLiteral("\xc3\xa4"), "\"\xc3\xa4\"");
}

TEST(LuaIdentifierTest, ExcludesReservedWordsAndOtherCharacters) {
  for (const char* name : {"a", "_", "max_range_m", "End", "x1"}) {
    EXPECT_TRUE(IsLuaIdentifier(name)) << name;
  }
  for (const char* name : {"", "1x", "a-b", "a b", "a.b", "end", "nil", "goto", "\xc3\xa4"}) {
    EXPECT_FALSE(IsLuaIdentifier(name)) << name;
  }
}

}  // namespace
}  // namespace cartographer::common
