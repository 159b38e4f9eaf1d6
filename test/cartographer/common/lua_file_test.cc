// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace cartographer::common {
namespace {

class LuaFileTest : public ::testing::Test {
 protected:
  LuaFileTest() : directory_(std::filesystem::path(::testing::TempDir()) / "lua_file_test") {
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_ / "a");
    std::filesystem::create_directories(directory_ / "b");
    std::ofstream(directory_ / "b" / "x.lua") << "return {}\n";
  }
  ~LuaFileTest() override { std::filesystem::remove_all(directory_); }

  std::string Path(const std::string& name) const { return (directory_ / name).string(); }

  const std::filesystem::path directory_;
};

TEST_F(LuaFileTest, FindsTheFirstThatExists) {
  EXPECT_EQ(*FindLuaFile("x.lua", {Path("a"), Path("b")}), Path("b/x.lua"));
  EXPECT_EQ(*FindLuaFile("../b/x.lua", {Path("a")}), Path("b/x.lua"));
  EXPECT_EQ(*FindLuaFile(Path("b/x.lua"), {}), Path("b/x.lua"));
  std::ofstream(Path("a/x.lua")) << "";
  EXPECT_EQ(*FindLuaFile("x.lua", {Path("a"), Path("b")}), Path("a/x.lua"));
}

TEST_F(LuaFileTest, SaysWhereItLooked) {
  EXPECT_EQ(FindLuaFile("y.lua", {Path("a"), ""}).status(),
            absl::NotFoundError("\"y.lua\" not found; looked in \"" + Path("a") + "\", \".\""));
  EXPECT_EQ(FindLuaFile("y.lua", {}).status(),
            absl::NotFoundError("\"y.lua\" not found; there is no directory to look in"));
  EXPECT_EQ(FindLuaFile("/no/y.lua", {}).status(),
            absl::NotFoundError("\"/no/y.lua\" does not exist"));
}

TEST_F(LuaFileTest, ReadsAllBytes) {
  EXPECT_EQ(*ReadLuaFile(Path("b/x.lua")), "return {}\n");
  const std::string bytes("\0\r\n\xff", 4);
  std::ofstream(Path("bytes.lua"), std::ios::binary) << bytes;
  EXPECT_EQ(*ReadLuaFile(Path("bytes.lua")), bytes);
  std::ofstream(Path("empty.lua")) << "";
  EXPECT_EQ(*ReadLuaFile(Path("empty.lua")), "");
  EXPECT_EQ(ReadLuaFile(Path("a")).status(),
            absl::InvalidArgumentError(Path("a") + ": is a directory, not a Lua file"));
  EXPECT_EQ(ReadLuaFile("/dev/zero").status(),
            absl::InvalidArgumentError("/dev/zero: is larger than 4 MiB; is it a Lua file?"));
}

}  // namespace
}  // namespace cartographer::common
