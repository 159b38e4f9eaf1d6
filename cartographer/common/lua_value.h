// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_LUA_VALUE_H_
#define CARTOGRAPHER_COMMON_LUA_VALUE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "absl/strings/string_view.h"

namespace cartographer::common {

struct LuaNamedValue;

// A value that a Lua file returned, freed from the interpreter: a plain tree.
struct LuaValue {
  enum class Kind {
    kBoolean,
    kInteger,
    kNumber,
    kString,
    kList,   // keys 1..n, n > 0
    kTable,  // string keys; the empty table is one too
    kUnusable
  };

  Kind kind = Kind::kUnusable;
  bool boolean = false;
  int64_t integer = 0;
  double number = 0.;
  std::string text;  // kString: its bytes; kUnusable: what it is, for example "a function"
  std::vector<LuaValue> list;
  std::vector<LuaNamedValue> named;  // kTable, in the order of the names' bytes

  bool IsEmptyTable() const;
  // The value called `name` in a table, nullptr if there is none.
  const LuaValue* Find(absl::string_view name) const;
};

struct LuaNamedValue {
  std::string name;
  LuaValue value;
};

// The value for an error message, on one line and of bounded length: `-3`, `"a string"`, `a list`.
std::string Describe(const LuaValue& value);

// `text` as a Lua string literal; bytes that do not print are written as \ddd.
std::string LuaStringLiteral(absl::string_view text);

// The shortest decimal number from which Lua reads exactly `number` back. NaN and the infinities
// have no literal and become expressions: (0/0), math.huge.
std::string LuaNumberLiteral(double number);

// The same for the nearest float: 0.1f becomes 0.1, though its double is 0.10000000149011612.
std::string LuaNumberLiteral(float number);

// Whether Lua takes `name` as a key without quotes.
bool IsLuaIdentifier(absl::string_view name);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_LUA_VALUE_H_
