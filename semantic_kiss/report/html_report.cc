// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/html_report.h"

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"

namespace semantic_kiss::report {
namespace {

constexpr char kStyle[] = R"(
  :root { color-scheme: light dark; }
  body { font: 15px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 0 auto; padding: 1rem; }
  h1 { margin-bottom: 0; }
  .subtitle { opacity: 0.7; margin-top: 0; }
  img { max-width: 100%; height: auto; border: 1px solid #8884; border-radius: 6px; }
  .tables { display: flex; flex-wrap: wrap; gap: 0 3rem; }
  table { border-collapse: collapse; }
  th, td { text-align: left; padding: 0.15rem 1rem 0.15rem 0; border-bottom: 1px solid #8884;
           vertical-align: top; }
  td + td { font-variant-numeric: tabular-nums; }
  pre { overflow-x: auto; background: #8881; padding: 1rem; border-radius: 6px; }
)";

std::string Escaped(absl::string_view text) {
  return absl::StrReplaceAll(
      text, {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"'", "&#39;"}});
}

std::string Row(const std::vector<std::string>& cells, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) {
    absl::StrAppend(&row, "<", tag, ">", Escaped(cell), "</", tag, ">");
  }
  return absl::StrCat(row, "</tr>\n");
}

std::string Section(const Table& table) {
  std::string html = absl::StrCat("<section>\n<h2>", Escaped(table.heading), "</h2>\n<table>\n");
  if (!table.header.empty()) html += Row(table.header, "th");
  for (const auto& row : table.rows) html += Row(row, "td");
  return absl::StrCat(html, "</table>\n</section>\n");
}

std::string Image(const std::string& png) {
  if (png.empty()) return "";
  return absl::StrCat("<img alt=\"The map from above\" src=\"data:image/png;base64,",
                      absl::Base64Escape(png), "\">\n");
}

}  // namespace

std::string Html(const Page& page) {
  std::string html = absl::StrCat(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n",
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>",
      Escaped(page.title), "</title>\n<style>", kStyle, "</style>\n</head>\n<body>\n<h1>",
      Escaped(page.title), "</h1>\n<p class=\"subtitle\">", Escaped(page.subtitle), "</p>\n");
  absl::StrAppend(&html, Image(page.image_png), "<div class=\"tables\">\n");
  for (const Table& table : page.tables) html += Section(table);
  absl::StrAppend(&html, "</div>\n<details>\n<summary>", Escaped(page.code_heading),
                  "</summary>\n<pre>", Escaped(page.code), "</pre>\n</details>\n",
                  "</body>\n</html>\n");
  return html;
}

}  // namespace semantic_kiss::report
