// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/option_constraint.h"

#include <cmath>

#include "absl/strings/str_cat.h"
#include "cartographer/common/lua_value.h"
#include "cartographer/common/nearest_name.h"
#include "google/protobuf/descriptor.h"

namespace cartographer::common {
namespace {

using google::protobuf::FieldDescriptor;

std::string DescribeNumber(const FieldDescriptor& field, const FieldDescriptor& annotated) {
  const bool is_real = field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE ||
                       field.cpp_type() == FieldDescriptor::CPPTYPE_FLOAT;
  const std::string kind = is_real ? "a number" : "an integer";
  const std::optional<proto::Range> range = RangeOf(annotated);
  const std::string bounds = range.has_value() ? DescribeRange(*range) : "";
  return bounds.empty() ? kind : absl::StrCat(kind, " with ", bounds);
}

}  // namespace

std::string DescribeRange(const proto::Range& range) {
  std::string below, above;
  if (range.has_above()) below = LuaNumberLiteral(range.above()) + " < ";
  if (range.has_at_least()) below = LuaNumberLiteral(range.at_least()) + " <= ";
  if (range.has_below()) above = " < " + LuaNumberLiteral(range.below());
  if (range.has_at_most()) above = " <= " + LuaNumberLiteral(range.at_most());
  if (below.empty() && above.empty()) return "";
  if (!above.empty()) return absl::StrCat(below, "x", above);
  return range.has_at_least() ? absl::StrCat("x >= ", LuaNumberLiteral(range.at_least()))
                              : absl::StrCat("x > ", LuaNumberLiteral(range.above()));
}

bool Satisfies(const proto::Range& range, double value) {
  if (std::isnan(value)) return false;
  if (range.has_above() && !(value > range.above())) return false;
  if (range.has_at_least() && !(value >= range.at_least())) return false;
  if (range.has_below() && !(value < range.below())) return false;
  return !range.has_at_most() || value <= range.at_most();
}

std::optional<proto::Range> RangeOf(const FieldDescriptor& field) {
  if (!field.options().HasExtension(proto::range)) return std::nullopt;
  return field.options().GetExtension(proto::range);
}

std::vector<std::string> WordsOf(const FieldDescriptor& field) {
  std::vector<std::string> words;
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM) {
    for (int i = 0; i < field.enum_type()->value_count(); ++i) {
      words.push_back(field.enum_type()->value(i)->name());
    }
    return words;
  }
  for (int i = 0; i < field.options().ExtensionSize(proto::one_of); ++i) {
    words.push_back(field.options().GetExtension(proto::one_of, i));
  }
  return words;
}

std::string DescribeScalar(const FieldDescriptor& field, const FieldDescriptor& annotated) {
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_BOOL) return "true or false";
  if (field.cpp_type() != FieldDescriptor::CPPTYPE_STRING &&
      field.cpp_type() != FieldDescriptor::CPPTYPE_ENUM) {
    return DescribeNumber(field, annotated);
  }
  const std::vector<std::string> words =
      WordsOf(field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM ? field : annotated);
  return words.empty() ? "a string" : absl::StrCat("one of ", QuotedList(words));
}

std::string DescribeRequirement(const FieldDescriptor& field) {
  if (!field.is_map() && field.is_repeated()) return "a list, { ... }";
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) return "a table with named keys";
  return DescribeScalar(field, field);
}

}  // namespace cartographer::common
