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
  // Whole strings in a message about a failure would be all of Leaflet.
  EXPECT_NE(PageFile("leaflet.js").find("CircleMarker"), std::string::npos);
  EXPECT_NE(PageFile("leaflet.css").find(".leaflet-container"), std::string::npos);
  // Debuggers would look for the file that this line names.
  EXPECT_EQ(PageFile("leaflet.js").find("sourceMappingURL"), std::string::npos);
}

TEST(PageFilesTest, UnknownNamesAreBugs) { EXPECT_DEATH(PageFile("no.js"), "no.js"); }

}  // namespace
}  // namespace semantic_kiss::report
