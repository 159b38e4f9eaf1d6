// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_LUA_TREE_H_
#define CARTOGRAPHER_COMMON_LUA_TREE_H_

#include "absl/status/statusor.h"
#include "cartographer/common/lua_value.h"
#include "lua.hpp"

namespace cartographer::common {

// Copies the value on top of the Lua stack into a plain tree; the stack is left as it was. What no
// option can be (functions, tables with list entries and named keys, lists with holes) becomes a
// value of kind kUnusable, so that the error can name the option. Raises no Lua errors.
//
// Error: tables nested too deep or too many values (a table that contains itself, for example).
absl::StatusOr<LuaValue> ReadLuaTree(lua_State* lua);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_LUA_TREE_H_
