// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/page_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace semantic_kiss::report {
namespace {

using ::testing::HasSubstr;

TEST(PageFilesTest, AreTheSourceTreesByteByByte) {
  const char* const source = std::getenv("SEMANTIC_KISS_SOURCE_DIR");
  if (source == nullptr) GTEST_SKIP() << "SEMANTIC_KISS_SOURCE_DIR is not set";
  for (const char* name : {"page.html", "page.css", "charts.js", "leaflet_license.txt"}) {
    std::stringstream content;
    content << std::ifstream(std::string(source) + "/semantic_kiss/report/page/" + name).rdbuf();
    EXPECT_EQ(PageFile(name), content.str()) << name;
  }
}

TEST(PageFilesTest, HasTheMapViewer) {
  EXPECT_THAT(PageFile("leaflet.js"), HasSubstr("1.7.1"));
  EXPECT_THAT(PageFile("leaflet.css"), HasSubstr(".leaflet-container"));
}

TEST(PageFilesTest, UnknownNamesAreBugs) { EXPECT_DEATH(PageFile("no.js"), "no.js"); }

}  // namespace
}  // namespace semantic_kiss::report
