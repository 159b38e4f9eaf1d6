// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_evaluator.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "cartographer/common/lua_sandbox.h"
#include "cartographer/common/lua_tree.h"
#include "cartographer/common/status.h"

namespace cartographer::common {
namespace {

// One file, or the source in memory.
struct Chunk {
  std::string path;                             // as errors show it
  std::string canonical_path;                   // tells files apart; empty for source in memory
  std::optional<size_t> parent = std::nullopt;  // the chunk that included it
  bool is_running = false;
};

// Lua shortens long names of chunks in its messages. It gets this one instead, which the final
// message replaces by the path.
std::string TokenOf(size_t chunk) { return absl::StrCat("<lua file ", chunk, ">"); }

class Evaluator {
 public:
  explicit Evaluator(std::vector<std::string> include_directories)
      : include_directories_(std::move(include_directories)) {
    lua_State* const lua = sandbox_.state();
    lua_pushlightuserdata(lua, this);
    lua_newtable(lua);
    lua_pushcclosure(lua, &Evaluator::LuaInclude, 2);
    lua_setglobal(lua, "include");
  }

  absl::StatusOr<LuaValue> EvaluateMain(Chunk chunk, const std::string& source) {
    chunks_.push_back(std::move(chunk));
    if (!Run(0, source)) return error_;
    lua_State* const lua = sandbox_.state();
    if (!lua_istable(lua, -1)) {
      return absl::InvalidArgumentError(absl::StrCat(
          chunks_[0].path, ": returned ", lua_isnil(lua, -1) ? "nothing" : luaL_typename(lua, -1),
          "; must end with `return` and a table: return { ... }"));
    }
    absl::StatusOr<LuaValue> value = ReadLuaTree(lua);
    if (!value.ok()) return AddContext(value.status(), chunks_[0].path);
    return value;
  }

 private:
  enum class Resolution { kFailed, kNew, kKnown };

  // The function `include` of the Lua files. Upvalues: the evaluator; the values of the files that
  // were included, by number of the chunk. Lua errors leave this function by longjmp, so that no
  // object with a destructor may live in it.
  static int LuaInclude(lua_State* lua) {
    const char* const name = luaL_checkstring(lua, 1);
    auto* const self = static_cast<Evaluator*>(lua_touserdata(lua, lua_upvalueindex(1)));
    size_t chunk = 0;
    switch (self->Include(lua, name, &chunk)) {
      case Resolution::kFailed:
        lua_pushnil(lua);  // the error itself waits in error_
        return lua_error(lua);
      case Resolution::kKnown:
        lua_rawgeti(lua, lua_upvalueindex(2), static_cast<lua_Integer>(chunk));
        return 1;
      case Resolution::kNew:
        lua_pushvalue(lua, -1);
        lua_rawseti(lua, lua_upvalueindex(2), static_cast<lua_Integer>(chunk));
        return 1;
    }
    return 0;
  }

  // kNew leaves the file's value on the stack.
  Resolution Include(lua_State* lua, const std::string& name, size_t* chunk);

  // The number of the chunk that called `include`, and where, as "path:line".
  size_t CallingChunk(lua_State* lua, std::string* where) const;

  // Runs a chunk and leaves its value on the stack; on failure sets error_, unless an include
  // within has done so, and leaves nothing.
  bool Run(size_t chunk, const std::string& source);

  Resolution Fail(absl::Status error) {
    error_ = std::move(error);
    return Resolution::kFailed;
  }

  absl::Status CycleError(size_t chunk, size_t from, const std::string& where) const;
  absl::Status ErrorOnStack(size_t chunk, int code);
  std::optional<size_t> FindChunk(const std::string& canonical_path) const;

  LuaSandbox sandbox_;
  const std::vector<std::string> include_directories_;
  std::vector<Chunk> chunks_;
  absl::Status error_;
};

std::string CanonicalPath(const std::string& path) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
  return error ? path : canonical.string();
}

Evaluator::Resolution Evaluator::Include(lua_State* lua, const std::string& name, size_t* chunk) {
  std::string where;
  const size_t from = CallingChunk(lua, &where);
  std::vector<std::string> directories = include_directories_;
  if (!chunks_[from].canonical_path.empty()) {
    directories.insert(directories.begin(),
                       std::filesystem::path(chunks_[from].path).parent_path().string());
  }
  const absl::StatusOr<std::string> path = FindLuaFile(name, directories);
  if (!path.ok()) return Fail(AddContext(path.status(), absl::StrCat(where, ": include")));

  const std::string canonical_path = CanonicalPath(*path);
  if (const std::optional<size_t> known = FindChunk(canonical_path); known.has_value()) {
    if (chunks_[*known].is_running) return Fail(CycleError(*known, from, where));
    *chunk = *known;
    return Resolution::kKnown;
  }
  const absl::StatusOr<std::string> source = ReadLuaFile(*path);
  if (!source.ok()) return Fail(AddContext(source.status(), absl::StrCat(where, ": include")));
  *chunk = chunks_.size();
  chunks_.push_back({*path, canonical_path, from});
  if (Run(*chunk, *source)) return Resolution::kNew;
  return Fail(
      absl::Status(error_.code(), absl::StrCat(error_.message(), " (included from ", where, ")")));
}

size_t Evaluator::CallingChunk(lua_State* lua, std::string* where) const {
  lua_Debug caller;
  size_t chunk = 0;
  if (lua_getstack(lua, 1, &caller) != 0 && lua_getinfo(lua, "Sl", &caller) != 0) {
    for (size_t i = 0; i < chunks_.size(); ++i) {
      if (caller.short_src == TokenOf(i)) chunk = i;
    }
    *where = absl::StrCat(chunks_[chunk].path, ":", caller.currentline);
  }
  return chunk;
}

bool Evaluator::Run(size_t chunk, const std::string& source) {
  lua_State* const lua = sandbox_.state();
  const std::string name = "=" + TokenOf(chunk);
  chunks_[chunk].is_running = true;
  int code = luaL_loadbufferx(lua, source.data(), source.size(), name.c_str(), "t");
  if (code == LUA_OK) code = lua_pcall(lua, 0, 1, 0);
  chunks_[chunk].is_running = false;
  if (code == LUA_OK) return true;
  if (error_.ok()) error_ = ErrorOnStack(chunk, code);
  lua_pop(lua, 1);
  return false;
}

absl::Status Evaluator::CycleError(size_t chunk, size_t from, const std::string& where) const {
  std::string chain = chunks_[chunk].path;
  for (size_t i = from; i != chunk; i = *chunks_[i].parent) {
    chain = absl::StrCat(chunks_[i].path, " -> ", chain);
  }
  return absl::InvalidArgumentError(absl::StrCat(where, ": include of a file that is still being ",
                                                 "read: ", chunks_[chunk].path, " -> ", chain));
}

absl::Status Evaluator::ErrorOnStack(size_t chunk, int code) {
  lua_State* const lua = sandbox_.state();
  std::string message;
  if (code == LUA_ERRMEM) {
    message = absl::StrCat("needs more than ", LuaSandbox::kMaxMemoryBytes >> 20,
                           " MiB of memory; is there an endless loop or recursion?");
  } else if (lua_type(lua, -1) == LUA_TSTRING) {
    message = lua_tostring(lua, -1);
  } else {
    message = absl::StrCat("raised an error that is a ", luaL_typename(lua, -1), ", not a text");
  }
  const bool has_position = absl::StartsWith(message, "<lua file ");
  for (size_t i = 0; i < chunks_.size(); ++i) {
    message = absl::StrReplaceAll(message, {{TokenOf(i), chunks_[i].path}});
  }
  message = absl::StrReplaceAll(message, {{"\n", " "}});
  if (!has_position) message = absl::StrCat(chunks_[chunk].path, ": ", message);
  return absl::InvalidArgumentError(message);
}

std::optional<size_t> Evaluator::FindChunk(const std::string& canonical_path) const {
  for (size_t i = 0; i < chunks_.size(); ++i) {
    if (chunks_[i].canonical_path == canonical_path) return i;
  }
  return std::nullopt;
}

}  // namespace

absl::StatusOr<LuaValue> EvaluateLuaFile(const LuaFile& file) {
  ASSIGN_OR_RETURN(const std::string source, ReadLuaFile(file.path));
  Evaluator evaluator(file.include_directories);
  return evaluator.EvaluateMain({file.path, CanonicalPath(file.path)}, source);
}

absl::StatusOr<LuaValue> EvaluateLuaSource(const std::string& source, const std::string& name,
                                           const std::vector<std::string>& include_directories) {
  Evaluator evaluator(include_directories);
  return evaluator.EvaluateMain({name, ""}, source);
}

}  // namespace cartographer::common
