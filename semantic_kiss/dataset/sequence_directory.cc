// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/sequence_directory.h"

#include <filesystem>
#include <system_error>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"

namespace semantic_kiss::dataset {

absl::StatusOr<std::string> SequenceDirectory(const std::string& root,
                                              const std::string& sequence) {
  if (sequence.empty() || sequence == "." || sequence == ".." || absl::StrContains(sequence, '/')) {
    return absl::InvalidArgumentError(absl::StrCat(
        "\"", sequence, "\" is not the name of a sequence; one folder is made of it, such as 00"));
  }
  return absl::StrCat(root, "/sequences/", sequence);
}

absl::Status MakeDirectory(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error) return absl::OkStatus();
  return absl::PermissionDeniedError(
      absl::StrCat(path, ": cannot make this directory: ", error.message()));
}

}  // namespace semantic_kiss::dataset
