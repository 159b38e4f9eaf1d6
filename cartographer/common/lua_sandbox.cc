// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_sandbox.h"

#include <cstdlib>
#include <initializer_list>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "cartographer/common/cpu_time.h"
#include "glog/logging.h"

namespace cartographer::common {
namespace {

// The order of a hash table changes from run to run; keys are sorted instead.
constexpr char kSortedPairs[] = R"lua(
local next, sort, type, error = next, table.sort, type, error
local function before(a, b)
  local type_a, type_b = type(a), type(b)
  if type_a ~= type_b then return type_a < type_b end
  if type_a == "boolean" then return b and not a end
  return a < b
end
function pairs(entries)
  if type(entries) ~= "table" then
    error("pairs() needs a table, not a value of type " .. type(entries), 2)
  end
  local keys = {}
  for key in next, entries do keys[#keys + 1] = key end
  sort(keys, before)
  local i = 0
  return function()
    repeat i = i + 1 until keys[i] == nil or entries[keys[i]] ~= nil
    return keys[i], entries[keys[i]]
  end
end
)lua";

// So few that what runs between two looks ends soon, even if each instruction sorts a long list.
constexpr int kInstructionsPerLook = 100;

// Replaces the table on top of the stack by a new one with only `names` in it.
void KeepOnly(lua_State* lua, std::initializer_list<const char*> names) {
  lua_newtable(lua);
  for (const char* name : names) {
    lua_getfield(lua, -2, name);
    lua_setfield(lua, -2, name);
  }
  lua_remove(lua, -2);
}

// `library` on top of the stack becomes a field of the table below it.
void OpenLibrary(lua_State* lua, const char* name, lua_CFunction open,
                 std::initializer_list<const char*> functions) {
  luaL_requiref(lua, name, open, 0);
  KeepOnly(lua, functions);
  lua_setfield(lua, -2, name);
}

// string.rep, its upvalue, but for nothing repeated for ever: the one call that neither memory nor
// instructions would limit.
int Repeat(lua_State* lua) {
  size_t text_size = 0, separator_size = 0;
  luaL_checklstring(lua, 1, &text_size);
  luaL_optlstring(lua, 3, "", &separator_size);
  if (text_size > 0 || separator_size > 0) {
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
  }
  lua_pushliteral(lua, "");
  return 1;
}

void Run(lua_State* lua, absl::string_view source, const char* name) {
  if (luaL_loadbufferx(lua, source.data(), source.size(), name, "t") != LUA_OK) lua_error(lua);
  lua_call(lua, 0, 0);
}

int OpenLibraries(lua_State* lua) {
  luaL_requiref(lua, "_G", luaopen_base, 0);
  KeepOnly(lua, {"assert", "error", "ipairs", "next", "rawequal", "rawget", "rawlen", "rawset",
                 "select", "tonumber", "tostring", "type"});
  OpenLibrary(lua, LUA_TABLIBNAME, luaopen_table,
              {"concat", "insert", "pack", "remove", "sort", "unpack"});
  OpenLibrary(lua, LUA_STRLIBNAME, luaopen_string,
              {"byte", "char", "format", "len", "lower", "rep", "reverse", "sub", "upper"});
  OpenLibrary(lua, LUA_MATHLIBNAME, luaopen_math,
              {"abs",  "acos", "asin", "atan", "ceil",       "cos",  "deg",        "exp",  "floor",
               "fmod", "huge", "log",  "max",  "maxinteger", "min",  "mininteger", "modf", "pi",
               "rad",  "sin",  "sqrt", "tan",  "tointeger",  "type", "ult"});
  lua_getfield(lua, -1, LUA_STRLIBNAME);
  lua_getfield(lua, -1, "rep");
  lua_pushcclosure(lua, Repeat, 1);
  lua_setfield(lua, -2, "rep");
  lua_pop(lua, 1);
  // Methods of strings, ("x"):upper(), come from the reduced library as well.
  lua_pushliteral(lua, "");
  lua_getmetatable(lua, -1);
  lua_getfield(lua, -3, LUA_STRLIBNAME);
  lua_setfield(lua, -2, "__index");
  lua_pop(lua, 2);

  lua_rawseti(lua, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  Run(lua, kSortedPairs, "=pairs");
  lua_pushnil(lua);
  lua_setglobal(lua, "next");
  return 0;
}

}  // namespace

LuaSandbox::LuaSandbox(double max_seconds)
    : max_seconds_(max_seconds),
      begin_s_(ThreadCpuSeconds()),
      state_(lua_newstate(&LuaSandbox::Allocate, this)) {
  CHECK(state_ != nullptr) << "no memory for a Lua state";
  lua_pushcfunction(state_, OpenLibraries);
  CHECK_EQ(lua_pcall(state_, 0, 0, 0), LUA_OK) << lua_tostring(state_, -1);
  lua_sethook(state_, &LuaSandbox::Watch, LUA_MASKCOUNT, kInstructionsPerLook);
}

LuaSandbox::~LuaSandbox() { lua_close(state_); }

void LuaSandbox::Watch(lua_State* lua, lua_Debug* where) {
  void* sandbox = nullptr;
  lua_getallocf(lua, &sandbox);
  auto* const self = static_cast<LuaSandbox*>(sandbox);
  self->instructions_ += kInstructionsPerLook;
  const bool too_many = self->instructions_ >= kMaxInstructions;
  if (!too_many && ThreadCpuSeconds() - self->begin_s_ < self->max_seconds_) return;
  lua_getinfo(lua, "Sl", where);
  const std::string limit = too_many ? absl::StrCat(kMaxInstructions, " instructions")
                                     : absl::StrCat(self->max_seconds_, " s");
  lua_pushfstring(lua, "%s:%d: stopped after %s; is there an endless loop?", where->short_src,
                  where->currentline, limit.c_str());
  lua_error(lua);
}

void* LuaSandbox::Allocate(void* sandbox, void* block, size_t old_size, size_t new_size) {
  auto* self = static_cast<LuaSandbox*>(sandbox);
  // For a new block Lua passes the kind of the object in place of the old size.
  if (block == nullptr) old_size = 0;
  if (new_size == 0) {
    std::free(block);
    self->memory_bytes_ -= old_size;
    return nullptr;
  }
  const bool grows = new_size > old_size;
  if (grows && (new_size - old_size > kMaxMemoryBytes - self->memory_bytes_ ||
                new_size > kMaxAllocatedBytes - self->allocated_bytes_)) {
    return nullptr;
  }
  void* const new_block = std::realloc(block, new_size);
  if (new_block == nullptr) return nullptr;
  self->memory_bytes_ += new_size - old_size;
  if (grows) self->allocated_bytes_ += new_size;
  return new_block;
}

}  // namespace cartographer::common
