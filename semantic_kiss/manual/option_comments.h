// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_MANUAL_OPTION_COMMENTS_H_
#define SEMANTIC_KISS_MANUAL_OPTION_COMMENTS_H_

#include <map>
#include <string>

#include "absl/status/statusor.h"

namespace semantic_kiss::manual {

// What the comments in .proto files say about messages and their fields. The generated code has
// everything else about them, but no comments.
class OptionComments {
 public:
  // Reads what `protoc --include_source_info --descriptor_set_out=PATH` has written.
  static absl::StatusOr<OptionComments> Read(const std::string& path);

  // The comment before a message or field, by its full name such as
  // "cartographer.slam.proto.MotionFilterOptions.max_time_s", as one line of text without slashes;
  // empty if there is none.
  std::string Of(const std::string& full_name) const;

 private:
  std::map<std::string, std::string> comments_;
};

}  // namespace semantic_kiss::manual

#endif  // SEMANTIC_KISS_MANUAL_OPTION_COMMENTS_H_
