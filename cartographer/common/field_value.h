// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_FIELD_VALUE_H_
#define CARTOGRAPHER_COMMON_FIELD_VALUE_H_

#include "absl/status/status.h"
#include "cartographer/common/lua_value.h"

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

namespace cartographer::common {

// Where a number, boolean, string or enum value goes.
struct FieldTarget {
  google::protobuf::Message* message;
  // Set, or appended to if repeated; not a message field.
  const google::protobuf::FieldDescriptor* field;
  // The field whose annotations bind the value: `field`, or for a map's values the map.
  const google::protobuf::FieldDescriptor* annotated;
};

// Checks the value and stores it. The error says what the value must be ("must satisfy x > 0").
absl::Status StoreScalar(const LuaValue& value, const FieldTarget& target);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_FIELD_VALUE_H_
