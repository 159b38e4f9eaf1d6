// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/lua_file.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "cartographer/common/nearest_name.h"

namespace cartographer::common {
namespace {

constexpr size_t kMaxFileBytes = size_t{4} << 20;

bool Exists(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

}  // namespace

absl::StatusOr<std::string> FindLuaFile(absl::string_view name,
                                        const std::vector<std::string>& directories) {
  const std::filesystem::path wanted{std::string(name)};
  if (wanted.is_absolute()) {
    if (Exists(wanted)) return wanted.string();
    return absl::NotFoundError(absl::StrCat("\"", name, "\" does not exist"));
  }
  for (const std::string& directory : directories) {
    const std::filesystem::path path = std::filesystem::path(directory) / wanted;
    if (Exists(path)) return path.lexically_normal().string();
  }
  std::vector<std::string> searched;
  for (const std::string& directory : directories) {
    searched.push_back(directory.empty() ? "." : directory);
  }
  return absl::NotFoundError(absl::StrCat("\"", name, "\" not found; ",
                                          searched.empty()
                                              ? "there is no directory to look in"
                                              : absl::StrCat("looked in ", QuotedList(searched))));
}

absl::StatusOr<std::string> ReadLuaFile(const std::string& path) {
  if (!Exists(path)) return absl::NotFoundError(absl::StrCat(path, ": no such file"));
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": is a directory, not a Lua file"));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": cannot be read: ", std::strerror(errno)));
  }
  // Read up to the limit rather than ask for the size: devices and pipes have none.
  std::string content(kMaxFileBytes + 1, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<size_t>(stream.gcount()));
  if (stream.bad()) return absl::InvalidArgumentError(absl::StrCat(path, ": cannot be read"));
  if (content.size() > kMaxFileBytes) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": is larger than ", kMaxFileBytes >> 20, " MiB; is it a Lua file?"));
  }
  return content;
}

}  // namespace cartographer::common
