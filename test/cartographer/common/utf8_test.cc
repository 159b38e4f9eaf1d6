// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace cartographer::common {
namespace {

TEST(Utf8Test, AcceptsTheFirstAndTheLastCharacterOfEachLength) {
  EXPECT_TRUE(IsUtf8(""));
  EXPECT_TRUE(IsUtf8(absl::string_view("\x00\x7f", 2)));
  EXPECT_TRUE(IsUtf8("\xC2\x80\xDF\xBF"));
  EXPECT_TRUE(IsUtf8("\xE0\xA0\x80\xEF\xBF\xBF"));
  EXPECT_TRUE(IsUtf8("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF"));
  EXPECT_TRUE(IsUtf8("\xED\x9F\xBF\xEE\x80\x80"));  // on both sides of the surrogates
}

TEST(Utf8Test, RejectsEverythingElse) {
  for (const char* bytes : {
           "\x80",
           "\xBF",
           "a\xC0\x80",
           "\xC1\xBF",  // stray continuations, overlong
           "\xE0\x9F\xBF",
           "\xF0\x8F\xBF\xBF",  // overlong
           "\xED\xA0\x80",
           "\xED\xBF\xBF",  // surrogates
           "\xF4\x90\x80\x80",
           "\xF5\x80\x80\x80",
           "\xFF",
           "\xC2",
           "\xC2 ",
           "\xE2\x82",
           "\xE2\x82 ",
           "\xF0\x9F\x98",
           "\xF0\x9F\x98x",
           "\xC2\x80\x80",
           "gr\xFC\xDF",  // Latin-1
       }) {
    EXPECT_FALSE(IsUtf8(bytes)) << bytes;
  }
}

// Counts what table 3-7 of the Unicode standard admits, by brute force over short strings.
TEST(Utf8Test, AcceptsAsManyStringsOfTwoAndThreeBytesAsThereAre) {
  int two = 0, three = 0;
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      std::string text = {static_cast<char>(a), static_cast<char>(b)};
      two += IsUtf8(text);
      text += '\0';
      for (int c = 0; c < 256; ++c) {
        text[2] = static_cast<char>(c);
        three += IsUtf8(text);
      }
    }
  }
  // Code points of one, two and three bytes.
  constexpr int kOne = 0x80, kTwo = 0x800 - 0x80, kThree = 0x10000 - 0x800 - 0x800;
  EXPECT_EQ(two, kOne * kOne + kTwo);
  EXPECT_EQ(three, kOne * kOne * kOne + 2 * kOne * kTwo + kThree);
}

}  // namespace
}  // namespace cartographer::common
