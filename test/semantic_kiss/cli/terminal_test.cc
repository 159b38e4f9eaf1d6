// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/terminal.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

namespace semantic_kiss::cli {
namespace {

TEST(TerminalTest, AFileIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  const Terminal terminal = Terminal::Of(fileno(file));
  EXPECT_FALSE(terminal.interactive);
  EXPECT_FALSE(terminal.colors);
  EXPECT_EQ(terminal.width, 80);
  std::fclose(file);
}

TEST(StyledTest, AddsEscapesOnlyWithColours) {
  EXPECT_EQ(Styled(Terminal{true, false, 80}, Style::kRed, "error"), "error");
  EXPECT_EQ(Styled(Terminal{true, true, 80}, Style::kRed, "error"), "\033[31merror\033[0m");
}

TEST(WrappedTest, BreaksAtBlanksAndIndents) {
  EXPECT_EQ(Wrapped("one two three four", 2, 11), "  one two\n  three\n  four");
  EXPECT_EQ(Wrapped("one\ntwo", 0, 80), "one two");
}

TEST(WrappedTest, KeepsParagraphsAndLongWords) {
  EXPECT_EQ(Wrapped("one\n\ntwo", 0, 80), "one\n\ntwo");
  EXPECT_EQ(Wrapped("a incomprehensibilities b", 0, 5), "a\nincomprehensibilities\nb");
}

TEST(WrappedTest, SurvivesNothing) {
  EXPECT_EQ(Wrapped("", 2, 10), "  ");
  EXPECT_EQ(Wrapped("word", 20, 10), std::string(20, ' ') + "word");
}

}  // namespace
}  // namespace semantic_kiss::cli
