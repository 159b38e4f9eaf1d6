// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_OPTIONS_LOADER_H_
#define CARTOGRAPHER_COMMON_OPTIONS_LOADER_H_

#include <string>
#include <vector>

#include "absl/status/status.h"

namespace google::protobuf {
class Message;
}

namespace cartographer::common {

// Options are declared once, as proto messages whose fields carry comments, units and ranges
// (proto/cartographer/common/proto/option_annotations.proto), and get their values from Lua,
// where alone the defaults live. This loader evaluates a Lua file and copies the table that it
// returns into such a message by reflection.
//
// Every field that the message declares must be in the table and every key of the table must be a
// field, else the error names the file, the full key path ("odometry.icp.max_iterations") and, for
// an unknown key, the nearest one that exists. Values are checked for type, range and, for
// strings, the allowed words. Fields declared `optional` may be missing (nil).
struct LuaFile {
  // Path of the file to evaluate. `include "other.lua"` in it is resolved first beside the
  // including file, then in `include_directories`, in order; each file is read at most once.
  std::string path;
  std::vector<std::string> include_directories;
};

// Fills `options` (cleared first). On error `options` is left in an unspecified state.
absl::Status LoadOptions(const LuaFile& file, google::protobuf::Message* options);

// The same for Lua source that is already in memory; `name` stands for the file in errors and
// `include` works as if the source stood in the first include directory.
absl::Status LoadOptionsFromString(const std::string& source, const std::string& name,
                                   const std::vector<std::string>& include_directories,
                                   google::protobuf::Message* options);

// The message as a Lua table that LoadOptionsFromString() reads back to an equal message: what
// `semantic_kiss config` prints and what maps carry. Numbers are written so that they survive the
// round trip exactly; keys stand in field order.
std::string OptionsToLua(const google::protobuf::Message& options);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_OPTIONS_LOADER_H_
