// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_LUA_SANDBOX_H_
#define CARTOGRAPHER_COMMON_LUA_SANDBOX_H_

#include <cstddef>
#include <cstdint>

#include "lua.hpp"

namespace cartographer::common {

// A Lua 5.3 state in which a configuration file can do no harm: it can neither reach files,
// processes and the clock nor run forever nor take all memory.
//  - Functions: those of the basic, table, string and math libraries that are pure. Left out are,
//    besides loading and printing: pcall (it could swallow the limits' errors), metatables,
//    patterns and table.move (they can run for ages inside one instruction), random numbers.
//  - pairs() visits keys in their order, so that a file gives the same values every time.
//  - After kMaxInstructions, after kMaxSeconds of processor time (library functions are single
//    instructions, however long their lists), with more than kMaxMemoryBytes in use, or after
//    kMaxAllocatedBytes in all (a loop that appends to a string spends its time there), Lua raises
//    an error.
// Not thread-safe; one state a file.
class LuaSandbox {
 public:
  static constexpr int kMaxInstructions = 10'000'000;
  static constexpr double kMaxSeconds = 10.;
  static constexpr size_t kMaxMemoryBytes = size_t{64} << 20;
  static constexpr size_t kMaxAllocatedBytes = size_t{1} << 30;

  explicit LuaSandbox(double max_seconds = kMaxSeconds);
  ~LuaSandbox();
  LuaSandbox(const LuaSandbox&) = delete;
  LuaSandbox& operator=(const LuaSandbox&) = delete;

  lua_State* state() { return state_; }

 private:
  static void Watch(lua_State* lua, lua_Debug* where);
  static void* Allocate(void* sandbox, void* block, size_t old_size, size_t new_size);

  const double max_seconds_;
  const double begin_s_;
  int instructions_ = 0;
  size_t memory_bytes_ = 0;     // in use
  size_t allocated_bytes_ = 0;  // in all
  lua_State* state_;
};

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_LUA_SANDBOX_H_
