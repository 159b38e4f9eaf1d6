// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_HTML_REPORT_H_
#define SEMANTIC_KISS_REPORT_HTML_REPORT_H_

#include <string>
#include <vector>

namespace semantic_kiss::report {

struct Table {
  std::string heading;
  std::vector<std::string> header;  // empty: the table has none
  std::vector<std::vector<std::string>> rows;
};

// What a report says, as plain text: it is escaped where HTML needs it.
struct Page {
  std::string title;
  std::string subtitle;
  std::string image_png;  // bytes of a PNG file; empty: no picture
  std::vector<Table> tables;
  std::string code_heading;
  std::string code;  // shown as it is, folded away
};

// The page as one file that needs no other: the picture is embedded, nothing is loaded from
// elsewhere.
std::string Html(const Page& page);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_HTML_REPORT_H_
