// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/html_report.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "semantic_kiss/report/html.h"
#include "semantic_kiss/report/json_text.h"
#include "semantic_kiss/report/page_files.h"
#include "semantic_kiss/report/report_json.h"

namespace semantic_kiss::report {
namespace {

std::string Element(absl::string_view tag, absl::string_view text) {
  if (text.empty()) return "";
  const absl::string_view name = tag.substr(0, tag.find(' '));
  return absl::StrCat("<", tag, ">", Escaped(text), "</", name, ">");
}

std::string FiguresHtml(const std::vector<Figure>& figures) {
  std::string html;
  for (const Figure& figure : figures) {
    absl::StrAppend(&html, "<div class=\"figure\"><dt>", Escaped(figure.name), "</dt><dd><b>",
                    Escaped(figure.value), "</b>", Element("span class=\"unit\"", figure.unit),
                    Element("small", figure.note), "</dd></div>\n");
  }
  return html;
}

std::string Row(const std::vector<std::string>& cells, absl::string_view tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) {
    absl::StrAppend(&row, "<", tag, ">", Escaped(cell), "</", tag.substr(0, tag.find(' ')), ">");
  }
  return absl::StrCat(row, "</tr>\n");
}

std::string TableHtml(const Table& table) {
  std::string html =
      absl::StrCat("<section>\n", Element("h2", table.heading),
                   Element("p class=\"note\"", table.note), "\n<div class=\"scroll\"><table>\n");
  if (!table.header.empty()) {
    absl::StrAppend(&html, "<thead>", Row(table.header, "th scope=\"col\""), "</thead>\n");
  }
  html += "<tbody>\n";
  for (const auto& row : table.rows) html += Row(row, "td");
  return absl::StrCat(html, "</tbody></table></div>\n</section>\n");
}

// The script draws into the figure; a reader without scripts sees heading and note.
std::string ChartHtml(const Chart& chart, size_t index) {
  return absl::StrCat("<section class=\"chart\">\n", Element("h2", chart.heading),
                      "<p class=\"note\">", Escaped(chart.note),
                      "</p>\n<div class=\"plot\" id=\"chart-", index, "\"></div>\n</section>\n");
}

std::string CodeHtml(const Report& report) {
  if (report.code.empty()) return "";
  return absl::StrCat("<details>\n<summary>", Escaped(report.code_heading),
                      "</summary>\n<pre tabindex=\"0\">", Escaped(report.code),
                      "</pre>\n</details>\n");
}

}  // namespace

std::string Html(const Report& report) {
  std::string charts, tables;
  for (size_t i = 0; i < report.charts.size(); ++i) charts += ChartHtml(report.charts[i], i);
  for (const Table& table : report.tables) tables += TableHtml(table);
  std::map<std::string, std::string> values = {
      {"title", Escaped(report.title)},
      {"subtitle", Escaped(report.subtitle)},
      {"figures", FiguresHtml(report.figures)},
      {"charts", std::move(charts)},
      {"tables", std::move(tables)},
      {"code", CodeHtml(report)},
      {"data", JsonForScript(JsonText(ReportJson(report)))}};
  for (const char* file :
       {"leaflet.css", "leaflet.js", "leaflet_license.txt", "page.css", "colors.js", "map_view.js",
        "drive.js", "panel.js", "closures.js", "charts.js", "page.js"}) {
    values[file] = PageFile(file);
  }
  return FillTemplate(PageFile("page.html"), values);
}

}  // namespace semantic_kiss::report
