// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_MESSAGE_FILLER_H_
#define CARTOGRAPHER_COMMON_MESSAGE_FILLER_H_

#include "absl/status/status.h"
#include "cartographer/common/lua_value.h"

namespace google::protobuf {
class Message;
}

namespace cartographer::common {

// Copies a table into a message (cleared first) by the rules of options_loader.h. The error, about
// the first thing that is wrong, does not name the file.
absl::Status FillMessage(const LuaValue& table, google::protobuf::Message* message);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_MESSAGE_FILLER_H_
