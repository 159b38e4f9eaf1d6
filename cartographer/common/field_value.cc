// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/field_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "cartographer/common/nearest_name.h"
#include "cartographer/common/option_constraint.h"
#include "cartographer/common/utf8.h"
#include "glog/logging.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/message.h"

namespace cartographer::common {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

// A member function of Reflection that sets a field, or appends to it.
template <typename T>
using Store = void (Reflection::*)(Message*, const FieldDescriptor*, T) const;

template <typename T>
void Put(const FieldTarget& target, T value, Store<T> set, Store<T> add) {
  const Store<T> store = target.field->is_repeated() ? add : set;
  (target.message->GetReflection()->*store)(target.message, target.field, std::move(value));
}

absl::Status Must(const std::string& what) {
  return absl::InvalidArgumentError(absl::StrCat("must ", what));
}

absl::Status MustBeAsDeclared(const FieldTarget& target) {
  return Must("be " + DescribeScalar(*target.field, *target.annotated));
}

absl::Status CheckRange(const FieldTarget& target, double value) {
  const std::optional<proto::Range> range = RangeOf(*target.annotated);
  if (!range.has_value() || Satisfies(*range, value)) return absl::OkStatus();
  return Must(absl::StrCat("satisfy ", DescribeRange(*range)));
}

// Integers, also those that are written as 100.0 or 1e2.
std::optional<int64_t> AsInteger(const LuaValue& value) {
  if (value.kind == LuaValue::Kind::kInteger) return value.integer;
  constexpr double kTwoTo63 = 9223372036854775808.;
  if (value.kind != LuaValue::Kind::kNumber || std::trunc(value.number) != value.number ||
      value.number < -kTwoTo63 || value.number >= kTwoTo63) {
    return std::nullopt;
  }
  return static_cast<int64_t>(value.number);
}

template <typename T>
absl::Status StoreInteger(const LuaValue& value, const FieldTarget& target, Store<T> set,
                          Store<T> add) {
  const std::optional<int64_t> integer = AsInteger(value);
  if (!integer.has_value()) return MustBeAsDeclared(target);
  // Lua has no integers beyond int64, so a uint64 field holds at most those.
  constexpr int64_t kMin = std::is_signed_v<T> ? int64_t{std::numeric_limits<T>::min()} : 0;
  constexpr int64_t kMax = sizeof(T) == 8 ? std::numeric_limits<int64_t>::max()
                                          : static_cast<int64_t>(std::numeric_limits<T>::max());
  if (const absl::Status status = CheckRange(target, static_cast<double>(*integer)); !status.ok()) {
    return status;
  }
  if (*integer < kMin || *integer > kMax) {
    return Must(absl::StrCat("satisfy ", kMin, " <= x <= ", kMax));
  }
  Put<T>(target, static_cast<T>(*integer), set, add);
  return absl::OkStatus();
}

template <typename T>
absl::Status StoreReal(const LuaValue& value, const FieldTarget& target, Store<T> set,
                       Store<T> add) {
  if (value.kind != LuaValue::Kind::kNumber && value.kind != LuaValue::Kind::kInteger) {
    return MustBeAsDeclared(target);
  }
  if (!std::isfinite(value.number)) return Must("be a finite number");
  if (const absl::Status status = CheckRange(target, value.number); !status.ok()) return status;
  const T number = static_cast<T>(value.number);
  if (!std::isfinite(number)) return Must("satisfy |x| < 3.4e38, the range of a 32-bit float");
  Put<T>(target, number, set, add);
  return absl::OkStatus();
}

absl::Status StoreBool(const LuaValue& value, const FieldTarget& target) {
  if (value.kind != LuaValue::Kind::kBoolean) return MustBeAsDeclared(target);
  Put<bool>(target, value.boolean, &Reflection::SetBool, &Reflection::AddBool);
  return absl::OkStatus();
}

absl::Status MustBeAWord(const std::string& text, const FieldTarget& target,
                         const std::vector<std::string>& words) {
  const std::string list = "be " + DescribeScalar(*target.field, *target.annotated);
  const std::string suggestion = SuggestName(text, words);
  // Without a near word the suggestion is a list once more.
  return Must(suggestion.back() == '?' ? absl::StrCat(list, "; ", suggestion) : list);
}

absl::Status StoreText(const LuaValue& value, const FieldTarget& target) {
  if (value.kind != LuaValue::Kind::kString) return MustBeAsDeclared(target);
  const std::vector<std::string> words = WordsOf(*target.annotated);
  if (!words.empty() && std::find(words.begin(), words.end(), value.text) == words.end()) {
    return MustBeAWord(value.text, target, words);
  }
  if (target.field->type() == FieldDescriptor::TYPE_STRING && !IsUtf8(value.text)) {
    return Must("be UTF-8; save the file in that encoding");
  }
  Put<std::string>(target, value.text, &Reflection::SetString, &Reflection::AddString);
  return absl::OkStatus();
}

absl::Status StoreEnum(const LuaValue& value, const FieldTarget& target) {
  if (value.kind != LuaValue::Kind::kString) return MustBeAsDeclared(target);
  const auto* const entry = target.field->enum_type()->FindValueByName(value.text);
  if (entry == nullptr) return MustBeAWord(value.text, target, WordsOf(*target.field));
  Put<const google::protobuf::EnumValueDescriptor*>(target, entry, &Reflection::SetEnum,
                                                    &Reflection::AddEnum);
  return absl::OkStatus();
}

}  // namespace

absl::Status StoreScalar(const LuaValue& value, const FieldTarget& target) {
  using R = Reflection;
  switch (target.field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return StoreInteger<int32_t>(value, target, &R::SetInt32, &R::AddInt32);
    case FieldDescriptor::CPPTYPE_INT64:
      return StoreInteger<int64_t>(value, target, &R::SetInt64, &R::AddInt64);
    case FieldDescriptor::CPPTYPE_UINT32:
      return StoreInteger<uint32_t>(value, target, &R::SetUInt32, &R::AddUInt32);
    case FieldDescriptor::CPPTYPE_UINT64:
      return StoreInteger<uint64_t>(value, target, &R::SetUInt64, &R::AddUInt64);
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return StoreReal<double>(value, target, &R::SetDouble, &R::AddDouble);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return StoreReal<float>(value, target, &R::SetFloat, &R::AddFloat);
    case FieldDescriptor::CPPTYPE_BOOL:
      return StoreBool(value, target);
    case FieldDescriptor::CPPTYPE_STRING:
      return StoreText(value, target);
    case FieldDescriptor::CPPTYPE_ENUM:
      return StoreEnum(value, target);
    case FieldDescriptor::CPPTYPE_MESSAGE:
      break;
  }
  LOG(FATAL) << target.field->full_name() << " is a message";
}

}  // namespace cartographer::common
