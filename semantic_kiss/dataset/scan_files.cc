// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/scan_files.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"

namespace semantic_kiss::dataset {
namespace {

bool IsScanName(const std::filesystem::path& name) {
  const std::string stem = name.stem().string();
  return name.extension() == ".bin" && std::all_of(stem.begin(), stem.end(), absl::ascii_isdigit);
}

absl::StatusOr<std::vector<ScanFile>> ListAll(const std::string& directory) {
  std::vector<ScanFile> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!IsScanName(entry->path().filename())) continue;
    ScanFile file{0, entry->path().stem().string()};
    if (!absl::SimpleAtoi(file.stem, &file.number)) {
      return absl::InvalidArgumentError(absl::StrCat(
          directory, ": ", file.stem, ".bin: the number is too large; rename the scans"));
    }
    files.push_back(std::move(file));
  }
  if (error) {
    return absl::ErrnoToStatus(error.value(), absl::StrCat(directory, ": cannot be listed"));
  }
  if (files.empty()) {
    return absl::NotFoundError(
        absl::StrCat(directory, ": has no scans; they are called 000000.bin, 000001.bin, ..."));
  }
  std::sort(files.begin(), files.end(), [](const ScanFile& a, const ScanFile& b) {
    return a.number != b.number ? a.number < b.number : a.stem < b.stem;
  });
  return files;
}

absl::Status CheckConsecutive(const std::string& directory, const std::vector<ScanFile>& files) {
  for (size_t i = 1; i < files.size(); ++i) {
    if (files[i].number == files[i - 1].number) {
      return absl::InvalidArgumentError(absl::StrCat(directory, ": ", files[i - 1].stem,
                                                     ".bin and ", files[i].stem,
                                                     ".bin have the same number; remove one"));
    }
    if (files[i].number != files[i - 1].number + 1) {
      return absl::InvalidArgumentError(
          absl::StrCat(directory, ": scan ", files[i - 1].number + 1, " is missing between ",
                       files[i - 1].stem, ".bin and ", files[i].stem,
                       ".bin; supply it, or run the stretches before and after it alone"));
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<ScanFile>> ListScanFiles(const std::string& directory,
                                                    const ScanRange& range) {
  ASSIGN_OR_RETURN(const std::vector<ScanFile> all, ListAll(directory));
  const int64_t first = range.first.value_or(all.front().number);
  const int64_t end = range.count.has_value() ? first + *range.count : int64_t{1} << 32;
  std::vector<ScanFile> files;
  std::copy_if(all.begin(), all.end(), std::back_inserter(files),
               [&](const ScanFile& file) { return file.number >= first && file.number < end; });
  if (files.empty() || files.front().number != first) {
    return absl::InvalidArgumentError(
        absl::StrCat(directory, ": has the scans ", all.front().number, " to ", all.back().number,
                     range.count.has_value() ? absl::StrCat(", not ", *range.count, " from ", first)
                                             : absl::StrCat(", not ", first)));
  }
  RETURN_IF_ERROR(CheckConsecutive(directory, files));
  return files;
}

}  // namespace semantic_kiss::dataset
