// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace cartographer::common {
namespace {

constexpr absl::string_view kReservedWords[] = {
    "and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
    "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
    "repeat",   "return", "then", "true", "until",  "while"};

std::string NonFiniteLiteral(double number) {
  if (std::isnan(number)) return "(0/0)";
  return number > 0. ? "math.huge" : "-math.huge";
}

// Six digits, as people write them, unless it takes more to get `number` back.
template <typename Number>
std::string ShortestLiteral(Number number, int max_digits) {
  if (!std::isfinite(number)) return NonFiniteLiteral(number);
  // As an integer, -0 would lose its sign.
  if (number == 0 && std::signbit(number)) return "-0.0";
  for (int digits = 6; digits < max_digits; ++digits) {
    std::string text = absl::StrFormat("%.*g", digits, number);
    double read_back = 0.;
    if (absl::SimpleAtod(text, &read_back) && static_cast<Number>(read_back) == number) return text;
  }
  return absl::StrFormat("%.*g", max_digits, number);
}

}  // namespace

bool LuaValue::IsEmptyTable() const { return kind == Kind::kTable && named.empty(); }

const LuaValue* LuaValue::Find(absl::string_view name) const {
  const auto it = std::lower_bound(
      named.begin(), named.end(), name,
      [](const LuaNamedValue& entry, absl::string_view key) { return entry.name < key; });
  return it != named.end() && it->name == name ? &it->value : nullptr;
}

std::string Describe(const LuaValue& value) {
  constexpr size_t kMaxLength = 60;
  switch (value.kind) {
    case LuaValue::Kind::kBoolean:
      return value.boolean ? "true" : "false";
    case LuaValue::Kind::kInteger:
      return absl::StrCat(value.integer);
    case LuaValue::Kind::kNumber: {
      if (std::isnan(value.number)) return "nan";
      if (std::isinf(value.number)) return value.number > 0. ? "inf" : "-inf";
      // A float stays one to the eye: 5.0 is not what 5 is.
      const std::string text = LuaNumberLiteral(value.number);
      return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
    }
    case LuaValue::Kind::kString:
      if (value.text.size() > kMaxLength) {
        return LuaStringLiteral(value.text.substr(0, kMaxLength)) + "...";
      }
      return LuaStringLiteral(value.text);
    case LuaValue::Kind::kList:
      return absl::StrCat("a list of ", value.list.size());
    case LuaValue::Kind::kTable:
      return value.named.empty() ? "an empty table" : "a table with named keys";
    case LuaValue::Kind::kUnusable:
      return value.text;
  }
  return "";
}

std::string LuaStringLiteral(absl::string_view text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      literal += '\\';
      literal += c;
    } else if (c == '\n') {
      literal += "\\n";
    } else if (absl::ascii_iscntrl(c)) {
      absl::StrAppendFormat(&literal, "\\%03d", static_cast<unsigned char>(c));
    } else {
      literal += c;
    }
  }
  return literal + "\"";
}

std::string LuaNumberLiteral(double number) { return ShortestLiteral(number, 17); }

std::string LuaNumberLiteral(float number) { return ShortestLiteral(number, 9); }

bool IsLuaIdentifier(absl::string_view name) {
  if (name.empty() || absl::ascii_isdigit(name[0])) return false;
  for (const char c : name) {
    if (!absl::ascii_isalnum(c) && c != '_') return false;
  }
  return std::find(std::begin(kReservedWords), std::end(kReservedWords), name) ==
         std::end(kReservedWords);
}

}  // namespace cartographer::common
