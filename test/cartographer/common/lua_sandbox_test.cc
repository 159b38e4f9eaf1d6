// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_sandbox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cartographer::common {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

// What the source returns, as text, or the error.
std::string Result(const std::string& source, double max_seconds = LuaSandbox::kMaxSeconds) {
  LuaSandbox sandbox(max_seconds);
  lua_State* const lua = sandbox.state();
  if (luaL_loadbufferx(lua, source.data(), source.size(), "=source", "t") == LUA_OK) {
    static_cast<void>(lua_pcall(lua, 0, 1, 0));
  }
  const char* const text = lua_tostring(lua, -1);
  return text == nullptr ? luaL_typename(lua, -1) : text;
}

TEST(LuaSandboxTest, OffersPureFunctionsOnly) {
  for (const char* name :
       {"io",           "os",          "debug",          "package",        "require",
        "coroutine",    "utf8",        "dofile",         "loadfile",       "load",
        "print",        "pcall",       "xpcall",         "collectgarbage", "setmetatable",
        "getmetatable", "next",        "string.find",    "string.gsub",    "string.dump",
        "table.move",   "math.random", "math.randomseed"}) {
    EXPECT_EQ(Result(std::string("return type(") + name + ")"), "nil") << name;
  }
  EXPECT_EQ(Result("return _G"), "nil");
  EXPECT_EQ(Result("return ('x').gsub"), "nil");
}

TEST(LuaSandboxTest, ComputesWhatFilesNeed) {
  EXPECT_EQ(Result("return math.rad(180) == math.pi and 'yes'"), "yes");
  EXPECT_EQ(Result("return ('ab'):upper() .. #'abc' .. string.format('%d', 4)"), "AB34");
  EXPECT_EQ(Result("local t = { 3, 1, 2 } table.sort(t) return table.concat(t, ',')"), "1,2,3");
  EXPECT_EQ(Result("local s = '' for i, x in ipairs { 5, 6 } do s = s .. i .. x end return s"),
            "1526");
}

TEST(LuaSandboxTest, VisitsPairsInTheOrderOfTheirKeys) {
  EXPECT_EQ(
      Result("local t = { b = 1, a = 2, [2] = 3, [1] = 4, [true] = 5, [false] = 6, [1.5] = 7 }\n"
             "local s = ''\n"
             "for k, v in pairs(t) do s = s .. tostring(k) .. '=' .. v .. ' ' end\n"
             "return s"),
      "false=6 true=5 1=4 1.5=7 2=3 a=2 b=1 ");
  EXPECT_EQ(Result("local t = { a = 1, b = 2, c = 3 }\n"
                   "local s = ''\n"
                   "for k in pairs(t) do s = s .. k t.b = nil end\n"
                   "return s"),
            "ac");
  EXPECT_EQ(Result("for k in pairs {} do return 'an entry' end return 'none'"), "none");
  EXPECT_EQ(Result("\npairs(nil)"), "source:2: pairs() needs a table, not a value of type nil");
}

TEST(LuaSandboxTest, StopsEndlessLoops) {
  EXPECT_EQ(Result("\nwhile true do end"),
            "source:2: stopped after 10000000 instructions; is there an endless loop?");
  EXPECT_THAT(Result("local function f() return f() end f()"), HasSubstr("stopped after"));
}

TEST(LuaSandboxTest, StopsWhatIsLongWithinFewInstructions) {
  EXPECT_EQ(Result("return ''..('').rep('', math.maxinteger)"), "");
  EXPECT_EQ(Result("return ('ab'):rep(2, '-')"), "ab-ab");
  constexpr double kMaxSeconds = 0.2;
  EXPECT_EQ(Result("local t = {} for i = 1, 400000 do table.insert(t, 1, 0) end return 'done'",
                   kMaxSeconds),
            "source:1: stopped after 0.2 s; is there an endless loop?");
}

TEST(LuaSandboxTest, StopsEndlessRecursion) {
  EXPECT_THAT(Result("local function f() return 1 + f() end f()"),
              AnyOf(HasSubstr("stack overflow"), "not enough memory"));
}

TEST(LuaSandboxTest, LimitsMemory) {
  EXPECT_EQ(Result("return #('x'):rep(1 << 24)"), "16777216");
  EXPECT_EQ(Result("return #('x'):rep(1 << 27)"),
            "source:1: not enough memory for buffer allocation");
  EXPECT_EQ(Result("local t = {} for i = 1, 1 << 30 do t[i] = i end"), "not enough memory");
  // Little is in use at a time, but a second of copying is enough.
  EXPECT_EQ(Result("local s = '' while true do s = s .. 'x' end"), "not enough memory");
}

}  // namespace
}  // namespace cartographer::common
