// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_evaluator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace cartographer::common {
namespace {

using ::testing::HasSubstr;

class LuaEvaluatorTest : public ::testing::Test {
 protected:
  LuaEvaluatorTest()
      : directory_(std::filesystem::path(::testing::TempDir()) /
                   (std::string("lua_evaluator_") +
                    ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
  }
  ~LuaEvaluatorTest() override { std::filesystem::remove_all(directory_); }

  std::string Path(const std::string& name) const { return (directory_ / name).string(); }

  std::string Write(const std::string& name, const std::string& source) {
    std::filesystem::create_directories(std::filesystem::path(Path(name)).parent_path());
    std::ofstream(Path(name)) << source;
    return Path(name);
  }

  // The entry `key` of the table that the file returns.
  std::string Text(const LuaFile& file, const std::string& key) {
    const absl::StatusOr<LuaValue> table = EvaluateLuaFile(file);
    if (!table.ok()) return std::string(table.status().message());
    const LuaValue* const value = table->Find(key);
    return value == nullptr ? "absent" : Describe(*value);
  }

  std::string Error(const std::string& path, std::vector<std::string> directories = {}) {
    return std::string(EvaluateLuaFile({path, std::move(directories)}).status().message());
  }

  const std::filesystem::path directory_;
};

std::string SourceError(const std::string& source) {
  const absl::StatusOr<LuaValue> value = EvaluateLuaSource(source, "main.lua", {});
  return std::string(value.status().message());
}

TEST_F(LuaEvaluatorTest, LetsDefaultsBeIncludedAndOverridden) {
  Write("defaults.lua", "OPTIONS = { gate_m = 1, name = 'default' }");
  const std::string main =
      Write("main.lua", "include 'defaults.lua'\nOPTIONS.gate_m = 2\nreturn OPTIONS");
  EXPECT_EQ(Text({main, {}}, "gate_m"), "2");
  EXPECT_EQ(Text({main, {}}, "name"), "\"default\"");
}

TEST_F(LuaEvaluatorTest, LooksBesideTheIncludingFileFirstThenInOrder) {
  Write("first/a.lua", "return 'first'");
  Write("second/a.lua", "return 'second'");
  Write("second/b.lua", "return 'second'");
  Write("beside/c.lua", "return 'beside'");
  Write("second/c.lua", "return 'second'");
  // What stands in a folder finds its neighbours from there.
  Write("beside/deep/d.lua", "return include 'e.lua'");
  Write("beside/deep/e.lua", "return 'deep'");
  const std::string main =
      Write("beside/main.lua",
            "return { a = include 'a.lua', b = include 'b.lua', c = include 'c.lua',"
            "         d = include 'deep/d.lua' }");
  const LuaFile file{main, {Path("first"), Path("second")}};
  EXPECT_EQ(Text(file, "a"), "\"first\"");
  EXPECT_EQ(Text(file, "b"), "\"second\"");
  EXPECT_EQ(Text(file, "c"), "\"beside\"");
  EXPECT_EQ(Text(file, "d"), "\"deep\"");
}

TEST_F(LuaEvaluatorTest, EvaluatesEachFileOnce) {
  Write("count.lua", "COUNT = (COUNT or 0) + 1\nreturn { value = COUNT }");
  Write("other.lua", "include 'count.lua'");
  const std::string main = Write(
      "main.lua",
      "local one = include 'count.lua'\ninclude 'other.lua'\nlocal two = include './count.lua'\n"
      "return { count = COUNT, same = one == two }");
  EXPECT_EQ(Text({main, {}}, "count"), "1");
  EXPECT_EQ(Text({main, {}}, "same"), "true");
}

TEST_F(LuaEvaluatorTest, NamesFileAndLineOfAnIncludeThatIsNotFound) {
  const std::string main = Write("main.lua", "\n\ninclude 'gone.lua'\nreturn {}");
  EXPECT_EQ(Error(main, {Path("x")}), main + ":3: include: \"gone.lua\" not found; looked in \"" +
                                          directory_.string() + "\", \"" + Path("x") + "\"");
  EXPECT_EQ(Error(Write("absolute.lua", "return include '/no/such.lua'")),
            Path("absolute.lua") + ":1: include: \"/no/such.lua\" does not exist");
  EXPECT_EQ(SourceError("include 'a.lua'"),
            "main.lua:1: include: \"a.lua\" not found; there is no directory to look in");
}

TEST_F(LuaEvaluatorTest, ShowsTheWayToAnErrorInAnIncludedFile) {
  const std::string inner = Write("inner.lua", "\nlocal x = nothing.at_all");
  const std::string middle = Write("middle.lua", "include 'inner.lua'");
  const std::string main = Write("main.lua", "\n\n\ninclude 'middle.lua'\nreturn {}");
  EXPECT_EQ(Error(main), inner +
                             ":2: attempt to index a nil value (global 'nothing') (included from " +
                             middle + ":1) (included from " + main + ":4)");
}

TEST_F(LuaEvaluatorTest, RefusesIncludesThatGoInCircles) {
  const std::string itself = Write("itself.lua", "include 'itself.lua'\nreturn {}");
  EXPECT_EQ(Error(itself),
            itself + ":1: include of a file that is still being read: " + itself + " -> " + itself);
  const std::string a = Write("a.lua", "include 'b.lua'\nreturn {}");
  const std::string b = Write("b.lua", "\ninclude 'c.lua'");
  const std::string c = Write("c.lua", "include 'a.lua'");
  EXPECT_THAT(Error(a), HasSubstr(c + ":1: include of a file that is still being read: " + a +
                                  " -> " + b + " -> " + c + " -> " + a));
}

TEST_F(LuaEvaluatorTest, RefusesWhatIsNoLuaFile) {
  const absl::Status missing = EvaluateLuaFile({Path("gone.lua"), {}}).status();
  EXPECT_EQ(missing.code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(missing.message(), Path("gone.lua") + ": no such file");
  EXPECT_EQ(Error(directory_.string()), directory_.string() + ": is a directory, not a Lua file");
  EXPECT_THAT(Error(Write("compiled.lua", "\x1bLua")), HasSubstr("attempt to load a binary chunk"));
  EXPECT_EQ(Error(Write("large.lua", std::string((4 << 20) + 1, ' '))),
            Path("large.lua") + ": is larger than 4 MiB; is it a Lua file?");
  EXPECT_THAT(Error(Write("main.lua", "include '.'")), HasSubstr("is a directory"));
}

TEST_F(LuaEvaluatorTest, ShowsLongPathsInFull) {
  const std::string path = Write(std::string(200, 'd') + "/main.lua", "\nx = 1 + nil");
  EXPECT_THAT(Error(path), HasSubstr(path + ":2: attempt to perform arithmetic on a nil value"));
}

TEST(LuaSourceTest, DemandsATable) {
  EXPECT_EQ(SourceError(""),
            "main.lua: returned nothing; must end with `return` and a table: return { ... }");
  EXPECT_EQ(SourceError("return 7"),
            "main.lua: returned number; must end with `return` and a table: return { ... }");
  EXPECT_EQ(SourceError("return {}"), "");
}

TEST(LuaSourceTest, ReportsErrorsOfEveryKind) {
  EXPECT_EQ(SourceError("\n\nx ="), "main.lua:3: unexpected symbol near <eof>");
  EXPECT_EQ(SourceError("error('a reason')"), "main.lua:1: a reason");
  EXPECT_EQ(SourceError("error('two\\nlines', 0)"), "main.lua: two lines");
  EXPECT_EQ(SourceError("error({})"), "main.lua: raised an error that is a table, not a text");
  EXPECT_EQ(SourceError("error()"), "main.lua: raised an error that is a nil, not a text");
  EXPECT_EQ(SourceError("assert(1 > 2, 'is not so')"), "main.lua:1: is not so");
  EXPECT_THAT(SourceError("include(nil)"), HasSubstr("main.lua:1: bad argument #1 to 'include'"));
}

TEST(LuaSourceTest, ReportsEndlessLoopsAndRecursions) {
  EXPECT_EQ(SourceError("\nwhile true do end"),
            "main.lua:2: stopped after 10000000 instructions; is there an endless loop?");
  EXPECT_EQ(SourceError("local t = {} while true do t = { t } end"),
            "main.lua: needs more than 64 MiB of memory; is there an endless loop or recursion?");
}

TEST(LuaSourceTest, RefusesTablesThatContainThemselves) {
  EXPECT_EQ(SourceError("local t = {} t.t = t return t"),
            "main.lua: the returned table is nested deeper than 64 levels or larger than 16 MiB; "
            "does a table contain itself?");
  EXPECT_THAT(SourceError("local t = {} for i = 1, 50 do t = { t, t } end return { t = t }"),
              HasSubstr("larger than 16 MiB"));
}

}  // namespace
}  // namespace cartographer::common
