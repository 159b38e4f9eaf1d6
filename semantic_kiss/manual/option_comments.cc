// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/option_comments.h"

#include <fstream>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "google/protobuf/descriptor.pb.h"

namespace semantic_kiss::manual {
namespace {

using google::protobuf::DescriptorProto;
using google::protobuf::FileDescriptorProto;

std::string OneLine(const std::string& comment) {
  return absl::StrJoin(absl::StrSplit(comment, absl::ByAnyChar(" \n"), absl::SkipEmpty()), " ");
}

// The full name of what stands at a path of SourceCodeInfo; empty if it is neither a message of the
// file nor a field of one. Options are not nested in one another.
std::string NameAt(const FileDescriptorProto& file,
                   const google::protobuf::RepeatedField<int>& path) {
  if (path.size() < 2 || path[0] != FileDescriptorProto::kMessageTypeFieldNumber) return "";
  const DescriptorProto& message = file.message_type(path[1]);
  const std::string name = absl::StrCat(file.package(), ".", message.name());
  if (path.size() == 2) return name;
  if (path.size() != 4 || path[2] != DescriptorProto::kFieldFieldNumber) return "";
  return absl::StrCat(name, ".", message.field(path[3]).name());
}

}  // namespace

absl::StatusOr<OptionComments> OptionComments::Read(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  google::protobuf::FileDescriptorSet files;
  if (!stream || !files.ParseFromIstream(&stream)) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": is no descriptor set of protoc"));
  }
  OptionComments result;
  for (const FileDescriptorProto& file : files.file()) {
    for (const auto& location : file.source_code_info().location()) {
      const std::string name = NameAt(file, location.path());
      if (!name.empty()) result.comments_[name] = OneLine(location.leading_comments());
    }
  }
  return result;
}

std::string OptionComments::Of(const std::string& full_name) const {
  const auto found = comments_.find(full_name);
  return found == comments_.end() ? "" : found->second;
}

}  // namespace semantic_kiss::manual
