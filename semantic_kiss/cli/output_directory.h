// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_OUTPUT_DIRECTORY_H_
#define SEMANTIC_KISS_CLI_OUTPUT_DIRECTORY_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"

namespace semantic_kiss::cli {

// The directory that takes a run's results.
class OutputDirectory {
 public:
  // Makes the directory and its parents where they are missing, and makes sure that files can be
  // written there: better to know before hours of work than after.
  static absl::StatusOr<OutputDirectory> Create(const std::string& path);

  OutputDirectory(OutputDirectory&& other) = default;
  OutputDirectory& operator=(OutputDirectory&& other) = delete;
  // Removes the directories that Create() made if they are still empty: a run that failed leaves
  // nothing.
  ~OutputDirectory();

  const std::string& path() const { return path_; }
  std::string FileNamed(absl::string_view name) const;

 private:
  explicit OutputDirectory(const std::string& path) : path_(path) {}

  std::string path_;
  std::vector<std::string> made_;  // outermost first
};

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_OUTPUT_DIRECTORY_H_
