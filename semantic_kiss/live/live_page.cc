// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/live_page.h"

#include <map>

#include "absl/strings/string_view.h"
#include "semantic_kiss/live/embedded_files.h"
#include "semantic_kiss/report/html.h"
#include "semantic_kiss/report/page_files.h"

namespace semantic_kiss::live {

std::string LivePage() {
  std::map<std::string, std::string> values;
  for (const char* file : {"leaflet.css", "leaflet.js", "leaflet_license.txt", "page.css",
                           "colors.js", "map_view.js", "drive.js"}) {
    values[file] = report::PageFile(file);
  }
  for (const EmbeddedFile& file : kEmbeddedFiles) values[file.name] = file.content;
  return report::FillTemplate(values.at("live.html"), values);
}

}  // namespace semantic_kiss::live
