// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/configuration_difference.h"

#include <map>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"

namespace semantic_kiss::cli {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

// A table that is being read: its path, and how many elements without a key it had.
struct OpenTable {
  std::string path;
  int num_elements = 0;
};

// The path of what a line begins or sets; `key` is empty for elements of lists.
std::string PathIn(OpenTable* table, absl::string_view key) {
  if (key.empty()) return absl::StrCat(table->path, "[", ++table->num_elements, "]");
  return table->path.empty() ? std::string(key) : absl::StrCat(table->path, ".", key);
}

// Key and value of a line such as `key = value,` or `value,`. Strings may hold the separator, but
// keys do not hold quotes.
std::pair<absl::string_view, absl::string_view> Parts(absl::string_view line) {
  const size_t separator = line.find(" = ");
  const size_t value = line.find_first_of("\"{");  // of a list: a string, a table on one line
  if (separator == absl::string_view::npos || value < separator) return {"", line};
  return {line.substr(0, separator), line.substr(separator + 3)};
}

Settings SettingsOf(const std::string& lua) {
  Settings settings;
  std::vector<OpenTable> tables;
  for (absl::string_view line : absl::StrSplit(lua, '\n')) {
    line = absl::StripAsciiWhitespace(line);
    absl::ConsumeSuffix(&line, ",");
    if (line.empty()) continue;
    if (line == "}") {
      if (!tables.empty()) tables.pop_back();
    } else if (tables.empty()) {
      tables.emplace_back();  // "return {"
    } else {
      const auto [key, value] = Parts(line);
      const std::string path = PathIn(&tables.back(), key);
      value == "{" ? tables.push_back({path}) : settings.push_back({path, std::string(value)});
    }
  }
  return settings;
}

}  // namespace

std::vector<ConfigurationDifference> Differences(const std::string& lua, const std::string& other) {
  const Settings settings = SettingsOf(lua), others = SettingsOf(other);
  std::map<std::string, std::string> left(others.begin(), others.end());
  std::vector<ConfigurationDifference> differences;
  for (const auto& [key, value] : settings) {
    const auto found = left.find(key);
    const std::string other_value = found == left.end() ? "" : found->second;
    if (value != other_value) differences.push_back({key, value, other_value});
    if (found != left.end()) left.erase(found);
  }
  for (const auto& [key, value] : others) {
    if (left.count(key) > 0) differences.push_back({key, "", value});
  }
  return differences;
}

}  // namespace semantic_kiss::cli
