// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/flag_list.h"

#include <cmath>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"

namespace semantic_kiss::cli {
namespace {

template <typename T, typename Parse>
absl::StatusOr<std::vector<T>> ValuesOf(absl::string_view list, const char* type,
                                        const Parse& parse) {
  std::vector<T> values;
  for (const std::string& word : WordsOf(list)) {
    T value;
    if (!parse(word, &value)) {
      return absl::InvalidArgumentError(
          absl::StrCat("`", word, "` is not ", type, "; separate numbers by commas"));
    }
    values.push_back(value);
  }
  return values;
}

}  // namespace

std::vector<std::string> WordsOf(absl::string_view list) {
  std::vector<std::string> words;
  for (const absl::string_view part : absl::StrSplit(list, ',', absl::SkipWhitespace())) {
    words.emplace_back(absl::StripAsciiWhitespace(part));
  }
  return words;
}

absl::StatusOr<std::vector<double>> NumbersOf(absl::string_view list) {
  return ValuesOf<double>(list, "a finite number", [](const std::string& word, double* value) {
    return absl::SimpleAtod(word, value) && std::isfinite(*value);
  });
}

absl::StatusOr<std::vector<int>> IntegersOf(absl::string_view list) {
  return ValuesOf<int>(list, "a whole number", [](const std::string& word, int* value) {
    return absl::SimpleAtoi(word, value);
  });
}

}  // namespace semantic_kiss::cli
