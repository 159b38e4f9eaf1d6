// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_LUA_FILE_H_
#define CARTOGRAPHER_COMMON_LUA_FILE_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"

namespace cartographer::common {

// A Lua file to evaluate.
struct LuaFile {
  // `include "other.lua"` in the file is resolved first beside the including file, then in
  // `include_directories`, in order; each file is evaluated at most once.
  std::string path;
  std::vector<std::string> include_directories;
};

// The path of the first of `directories` in which a file called `name` exists; `name` itself if it
// is an absolute path. "" stands for the working directory. NotFound lists where was looked.
absl::StatusOr<std::string> FindLuaFile(absl::string_view name,
                                        const std::vector<std::string>& directories);

// The whole file. NotFound, or InvalidArgument if it is a directory, not readable or larger than
// 4 MiB; the message starts with the path.
absl::StatusOr<std::string> ReadLuaFile(const std::string& path);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_LUA_FILE_H_
