// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_LUA_EVALUATOR_H_
#define CARTOGRAPHER_COMMON_LUA_EVALUATOR_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/common/lua_file.h"
#include "cartographer/common/lua_value.h"

namespace cartographer::common {

// Evaluates a Lua file in a LuaSandbox and returns the table that it returns.
//
// `include "defaults.lua"` evaluates another file (lua_file.h says where it is looked for) among
// the same globals: those that it sets are visible to the including file, which may change them
// before it returns them. It gives what that file returns. A file is evaluated at the first
// include; later ones give the same value again.
//
// Errors name the file as it was found, and the line: syntax and runtime errors (an endless loop
// or a full memory are such), includes that are not found or that lead back to a file that is
// still being evaluated. A result that is not a table is an error too.
absl::StatusOr<LuaValue> EvaluateLuaFile(const LuaFile& file);

// The same for source in memory, which errors call `name`; its includes are looked for in
// `include_directories` alone.
absl::StatusOr<LuaValue> EvaluateLuaSource(const std::string& source, const std::string& name,
                                           const std::vector<std::string>& include_directories);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_LUA_EVALUATOR_H_
