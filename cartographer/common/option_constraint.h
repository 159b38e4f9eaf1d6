// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_OPTION_CONSTRAINT_H_
#define CARTOGRAPHER_COMMON_OPTION_CONSTRAINT_H_

#include <optional>
#include <string>
#include <vector>

#include "cartographer/common/proto/option_annotations.pb.h"

namespace google::protobuf {
class FieldDescriptor;
}

namespace cartographer::common {

// What the declaration of an option demands of its value, in words and as a check.

// The bounds as people write them: "0 < x <= 500", "x >= 0"; empty if nothing binds.
std::string DescribeRange(const proto::Range& range);

// Whether `value` lies within the bounds; NaN never does.
bool Satisfies(const proto::Range& range, double value);

// The range annotated at a field; nothing if there is none.
std::optional<proto::Range> RangeOf(const google::protobuf::FieldDescriptor& field);

// The words that a field may take: the annotated ones of a string, the values of an enum; empty if
// any will do.
std::vector<std::string> WordsOf(const google::protobuf::FieldDescriptor& field);

// What one number, boolean, string or word of the field must be: "an integer with 0 < x <= 500",
// "true or false", "a string", `one of "linear", "nearest"`. `annotated` is the field whose
// annotations bind the value: the field itself, or for a map's values the map.
std::string DescribeScalar(const google::protobuf::FieldDescriptor& field,
                           const google::protobuf::FieldDescriptor& annotated);

// What the whole field must be: as above, "a list, { ... }" or "a table with named keys".
std::string DescribeRequirement(const google::protobuf::FieldDescriptor& field);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_OPTION_CONSTRAINT_H_
