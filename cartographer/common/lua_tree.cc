// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_tree.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"

namespace cartographer::common {
namespace {

constexpr int kMaxDepth = 64;
// A value counts as its text plus this. Tables that share others grow when they become a tree, so
// the limit on Lua's memory is none for the tree.
constexpr size_t kBytesOfAValue = 64;
constexpr size_t kMaxBytes = size_t{16} << 20;

LuaValue Unusable(std::string what) {
  LuaValue value;
  value.text = std::move(what);
  return value;
}

class TreeReader {
 public:
  explicit TreeReader(lua_State* lua) : lua_(lua) {}

  // Reads the value on top of the stack, which lies `depth` tables deep.
  LuaValue Read(int depth);

  bool over_limit() const { return over_limit_; }

 private:
  struct Entries {
    std::vector<std::pair<int64_t, LuaValue>> indexed;
    std::vector<LuaNamedValue> named;
    bool has_other_keys = false;
  };

  LuaValue ReadText();
  LuaValue ReadTable(int depth);
  Entries ReadEntries(int depth);
  void ReadEntry(int depth, Entries* entries);
  void Spend(size_t bytes) {
    bytes_ += bytes;
    if (bytes_ > kMaxBytes) over_limit_ = true;
  }

  lua_State* const lua_;
  size_t bytes_ = 0;
  bool over_limit_ = false;
};

LuaValue TreeReader::Read(int depth) {
  Spend(kBytesOfAValue);
  LuaValue value;
  switch (lua_type(lua_, -1)) {
    case LUA_TBOOLEAN:
      value.kind = LuaValue::Kind::kBoolean;
      value.boolean = lua_toboolean(lua_, -1) != 0;
      return value;
    case LUA_TNUMBER:
      value.kind = lua_isinteger(lua_, -1) ? LuaValue::Kind::kInteger : LuaValue::Kind::kNumber;
      value.integer = lua_tointeger(lua_, -1);
      value.number = lua_tonumber(lua_, -1);
      return value;
    case LUA_TSTRING:
      return ReadText();
    case LUA_TTABLE:
      return ReadTable(depth);
    default:
      return Unusable(absl::StrCat("a ", luaL_typename(lua_, -1)));
  }
}

LuaValue TreeReader::ReadText() {
  LuaValue value;
  value.kind = LuaValue::Kind::kString;
  size_t size = 0;
  const char* const bytes = lua_tolstring(lua_, -1, &size);
  Spend(size);
  if (!over_limit_) value.text.assign(bytes, size);
  return value;
}

// Turns the indexed entries of a table, sorted by index, into a list.
LuaValue MakeList(std::vector<std::pair<int64_t, LuaValue>> entries) {
  LuaValue value;
  value.kind = LuaValue::Kind::kList;
  for (auto& [index, entry] : entries) {
    const int64_t expected = static_cast<int64_t>(value.list.size()) + 1;
    if (index != expected) {
      return Unusable(index < expected ? absl::StrCat("a list with index ", index)
                                       : absl::StrCat("a list without entry ", expected));
    }
    value.list.push_back(std::move(entry));
  }
  return value;
}

LuaValue TreeReader::ReadTable(int depth) {
  if (depth >= kMaxDepth || lua_checkstack(lua_, 3) == 0) over_limit_ = true;
  if (over_limit_) return LuaValue();
  Entries entries = ReadEntries(depth);
  if (entries.has_other_keys) {
    return Unusable("a table with keys that are neither strings nor list indices");
  }
  if (!entries.indexed.empty() && !entries.named.empty()) {
    return Unusable("a table with both list entries and named keys");
  }
  if (!entries.indexed.empty()) {
    std::sort(entries.indexed.begin(), entries.indexed.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return MakeList(std::move(entries.indexed));
  }
  std::sort(entries.named.begin(), entries.named.end(),
            [](const LuaNamedValue& a, const LuaNamedValue& b) { return a.name < b.name; });
  LuaValue value;
  value.kind = LuaValue::Kind::kTable;
  value.named = std::move(entries.named);
  return value;
}

TreeReader::Entries TreeReader::ReadEntries(int depth) {
  Entries entries;
  lua_pushnil(lua_);
  while (lua_next(lua_, -2) != 0) {
    if (over_limit_) {
      lua_pop(lua_, 2);
      break;
    }
    ReadEntry(depth, &entries);
    lua_pop(lua_, 1);
  }
  return entries;
}

void TreeReader::ReadEntry(int depth, Entries* entries) {
  LuaValue value = Read(depth + 1);
  if (lua_isinteger(lua_, -2)) {
    entries->indexed.emplace_back(lua_tointeger(lua_, -2), std::move(value));
  } else if (lua_type(lua_, -2) == LUA_TSTRING) {
    size_t size = 0;
    const char* const bytes = lua_tolstring(lua_, -2, &size);
    Spend(size);
    if (!over_limit_) entries->named.push_back({std::string(bytes, size), std::move(value)});
  } else {
    entries->has_other_keys = true;
  }
}

}  // namespace

absl::StatusOr<LuaValue> ReadLuaTree(lua_State* lua) {
  TreeReader reader(lua);
  LuaValue value = reader.Read(0);
  if (reader.over_limit()) {
    return absl::InvalidArgumentError(
        absl::StrCat("the returned table is nested deeper than ", kMaxDepth, " levels or larger ",
                     "than ", kMaxBytes >> 20, " MiB; does a table contain itself?"));
  }
  return value;
}

}  // namespace cartographer::common
