// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/json_text.h"

#include <gtest/gtest.h>

namespace semantic_kiss::report {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonTextTest, KeepsTheOrderAndLaysOutAsAsked) {
  const Json json = {{"b", 1}, {"a", {true, nullptr}}};
  EXPECT_EQ(JsonText(json), "{\"b\":1,\"a\":[true,null]}");
  EXPECT_EQ(JsonText(json, 2), "{\n  \"b\": 1,\n  \"a\": [\n    true,\n    null\n  ]\n}");
}

TEST(JsonTextTest, KeepsUtf8) { EXPECT_EQ(JsonText("caf\xc3\xa9"), "\"caf\xc3\xa9\""); }

TEST(JsonTextTest, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(JsonText("caf\xe9"), "\"caf\xef\xbf\xbd\"");
  EXPECT_EQ(JsonText({{"\xff", "\xc3"}}), "{\"\xef\xbf\xbd\":\"\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace semantic_kiss::report
