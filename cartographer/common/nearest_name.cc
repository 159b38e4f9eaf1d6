// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/nearest_name.h"

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace cartographer::common {
namespace {

constexpr size_t kMaxListed = 8;

// Names in a file may be of any length; nobody mistypes that many characters.
constexpr size_t kMaxComparedLength = 100;

bool SameLetter(char a, char b) { return absl::ascii_tolower(a) == absl::ascii_tolower(b); }

bool OneContainsTheOther(absl::string_view a, absl::string_view b) {
  constexpr size_t kShortestTellingPart = 3;
  if (std::min(a.size(), b.size()) < kShortestTellingPart) return false;
  const std::string lower_a = absl::AsciiStrToLower(a), lower_b = absl::AsciiStrToLower(b);
  return absl::StrContains(lower_a, lower_b) || absl::StrContains(lower_b, lower_a);
}

int Distance(absl::string_view name, absl::string_view known) {
  const int edits = EditDistance(name.substr(0, kMaxComparedLength), known);
  return OneContainsTheOther(name, known) ? std::min(edits, 1) : edits;
}

// A slip touches few of the letters; beyond a third of them, it is another word.
bool IsSlip(int distance, size_t length) {
  return distance <= std::max<int>(1, static_cast<int>(length) / 3);
}

}  // namespace

int EditDistance(absl::string_view a, absl::string_view b) {
  // Rows i-2, i-1 and i of the table whose entry [i][j] is the distance of the first i characters
  // of `a` to the first j of `b`.
  std::vector<int> before_last(b.size() + 1), last(b.size() + 1), current(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) current[j] = static_cast<int>(j);
  for (size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, current);
    current[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (SameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
      current[j] = std::min({replaced, last[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && SameLetter(a[i - 1], b[j - 2]) && SameLetter(a[i - 2], b[j - 1])) {
        current[j] = std::min(current[j], before_last[j - 2] + 1);
      }
    }
  }
  return current[b.size()];
}

std::vector<std::string> NearestNames(absl::string_view name, const std::vector<std::string>& known,
                                      size_t max_names) {
  std::vector<std::pair<int, size_t>> by_distance;
  for (size_t i = 0; i < known.size(); ++i) by_distance.emplace_back(Distance(name, known[i]), i);
  std::sort(by_distance.begin(), by_distance.end());
  if (by_distance.size() > max_names) by_distance.resize(max_names);
  std::vector<std::string> nearest;
  for (const auto& [distance, index] : by_distance) nearest.push_back(known[index]);
  return nearest;
}

std::string NearestName(absl::string_view name, const std::vector<std::string>& known) {
  const std::vector<std::string> nearest = NearestNames(name, known, 1);
  return nearest.empty() ? std::string() : nearest.front();
}

std::string SuggestName(absl::string_view name, const std::vector<std::string>& known) {
  if (known.empty()) return "none is known here";
  const std::vector<std::string> nearest = NearestNames(name, known, kMaxListed);
  const size_t length = std::min(name.size(), nearest.front().size());
  if (IsSlip(Distance(name, nearest.front()), length)) {
    return absl::StrCat("did you mean \"", nearest.front(), "\"?");
  }
  return absl::StrCat("known: ", QuotedList(nearest), known.size() > nearest.size() ? ", ..." : "");
}

std::string QuotedList(const std::vector<std::string>& names) {
  return absl::StrJoin(names, ", ", [](std::string* out, const std::string& name) {
    absl::StrAppend(out, "\"", name, "\"");
  });
}

}  // namespace cartographer::common
