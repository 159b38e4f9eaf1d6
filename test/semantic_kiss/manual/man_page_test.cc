// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/man_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace semantic_kiss::manual {
namespace {

using ::testing::HasSubstr;

TEST(RoffTextTest, LeavesNothingThatRoffWouldObey) {
  EXPECT_EQ(RoffText(""), "");
  EXPECT_EQ(RoffText("a.b 'c' x-y"), "a.b 'c' x-y");
  EXPECT_EQ(RoffText(".so file"), "\\&.so file");
  EXPECT_EQ(RoffText("'so file"), "\\&'so file");
  EXPECT_EQ(RoffText("a\n.b\n'c"), "a\n\\&.b\n\\&'c");
  EXPECT_EQ(RoffText("a\\b"), "a\\eb");
  EXPECT_EQ(RoffText("--map"), "\\-\\-map");
}

TEST(ManPageTest, ExamplesAreToBeCopied) {
  cli::Command command;
  command.name = "try";
  command.description = "First.\n\n.Second.";
  command.examples = {{"What it does", "try --map=a-b.pbstream"}};
  const std::string page = ManPage({command}, "1.2.3");
  EXPECT_THAT(page, HasSubstr(".TH SEMANTIC_KISS 1 \"\" \"semantic_kiss 1.2.3\""));
  EXPECT_THAT(page, HasSubstr(".SS try\nFirst.\n.PP\n\\&.Second.\n"));
  EXPECT_THAT(page, HasSubstr("\nsemantic_kiss try \\-\\-map=a\\-b.pbstream\n"));
}

}  // namespace
}  // namespace semantic_kiss::manual
