// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_OPTIONS_LOADER_H_
#define CARTOGRAPHER_COMMON_OPTIONS_LOADER_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "cartographer/common/lua_file.h"

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

namespace cartographer::common {

// Options are declared once, as proto messages whose fields carry comments, units and ranges
// (proto/cartographer/common/proto/option_annotations.proto), and get their values from Lua,
// where alone the defaults live. This loader evaluates a Lua file (lua_evaluator.h) and copies the
// table that it returns into such a message by reflection.
//
// Every field that the message declares must be in the table and every key of the table must be a
// field. A number must be finite and in range; an integer may be written as 100, 100.0 or 1e2, but
// not as 100.5. Strings are one of the allowed words, if the field names some, and UTF-8. Enums
// are the names of their values. A repeated field is a list, {} if it has no elements; a map with
// string keys is a table; of the members of a oneof, one may be present. Only fields declared
// `optional` may be missing (nil). A field of another kind (a map with other keys) is a bug.
//
// Errors are one line and name the file, the full key path, the value and what it must be:
//   kitti.lua: odometry.icp.max_iterations = -3; must satisfy 0 < x <= 500
//   kitti.lua: unknown key odometry.icp.max_iteration; did you mean "max_iterations"?
//   kitti.lua: missing key labels.classes[3].name; must be a string
// If there are several, the message is about the first (of a table: unknown keys by name, then the
// fields in the order of their declaration) and ends with "(and 2 more errors)".

// Fills `options` (cleared first). On error `options` is left in an unspecified state.
absl::Status LoadOptions(const LuaFile& file, google::protobuf::Message* options);

// The same for Lua source that is already in memory; `name` stands for the file in errors and
// `include` looks in `include_directories` alone.
absl::Status LoadOptionsFromString(const std::string& source, const std::string& name,
                                   const std::vector<std::string>& include_directories,
                                   google::protobuf::Message* options);

// What LoadOptions() would have to say of a message that something else changed as well; `name`
// stands for the file in errors.
absl::Status CheckOptions(const google::protobuf::Message& options, const std::string& name);

// The message as a Lua table: what `semantic_kiss config` prints and what maps carry.
// LoadOptionsFromString() reads a message that LoadOptions() filled back to an equal one, numbers
// to the last bit. Keys stand in the order of the fields' declaration, keys of maps in their own.
std::string OptionsToLua(const google::protobuf::Message& options);

// The value of one field of it, on one line however long: what would follow the key.
std::string OptionToLua(const google::protobuf::Message& options,
                        const google::protobuf::FieldDescriptor& field);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_OPTIONS_LOADER_H_
