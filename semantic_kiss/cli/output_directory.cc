// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/output_directory.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "absl/strings/str_cat.h"
#include "cartographer/io/atomic_file.h"

namespace semantic_kiss::cli {
namespace {

namespace fs = std::filesystem;

// The directories of `path` that do not exist, outermost first.
std::vector<std::string> MissingDirectories(const fs::path& path) {
  std::vector<std::string> missing;
  std::error_code ignored;
  for (fs::path part = path; !part.empty() && !fs::exists(part, ignored);
       part = part.parent_path()) {
    missing.push_back(part.string());
  }
  std::reverse(missing.begin(), missing.end());
  return missing;
}

}  // namespace

absl::StatusOr<OutputDirectory> OutputDirectory::Create(const std::string& path) {
  std::error_code error;
  const fs::path normal = fs::absolute(path, error).lexically_normal();
  OutputDirectory directory(path);
  const std::vector<std::string> missing = MissingDirectories(normal);
  for (const std::string& part : missing) {
    if (fs::create_directory(part, error)) directory.made_.push_back(part);
    if (error) break;
  }
  if (!error && !fs::is_directory(normal, error) && !error) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) {
    return absl::FailedPreconditionError(
        absl::StrCat(path, ": cannot be made the output directory: ", error.message(),
                     "; choose another --output or correct its permissions"));
  }
  // A file that is not committed leaves no trace.
  const auto trial = cartographer::io::AtomicFile::Create(directory.FileNamed("run.json"));
  if (!trial.ok()) {
    return absl::FailedPreconditionError(absl::StrCat(trial.status().message(),
                                                      "; choose another --output or correct its "
                                                      "permissions"));
  }
  return directory;
}

OutputDirectory::~OutputDirectory() {
  for (auto part = made_.rbegin(); part != made_.rend(); ++part) {
    ::rmdir(part->c_str());  // fails where there is something in it, as it should
  }
}

std::string OutputDirectory::FileNamed(absl::string_view name) const {
  return (fs::path(path_) / std::string(name)).string();
}

}  // namespace semantic_kiss::cli
