// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/testing/test_files.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "glog/logging.h"

namespace semantic_kiss_testing {

TemporaryDirectory::TemporaryDirectory() {
  path_ = (std::filesystem::temp_directory_path() / "semantic_kiss_XXXXXX").string();
  CHECK(mkdtemp(path_.data()) != nullptr) << path_;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void WriteText(const std::string& path, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text << std::flush;
  CHECK(file.good()) << path;
}

std::string ReadText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  CHECK(file.good()) << path;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::optional<std::string> RealDataDirectory() {
  const char* const given = std::getenv("SEMANTIC_KISS_DATA");
  const std::string path = given != nullptr ? given : SourceFile("../shared/data");
  if (std::filesystem::is_directory(path)) return path;
  std::cerr << "*** NO REAL DATA at " << path
            << ": set SEMANTIC_KISS_DATA to test with real scans ***\n";
  return std::nullopt;
}

std::string SourceFile(const std::string& name) {
  const char* const root = std::getenv("SEMANTIC_KISS_SOURCE_DIR");
  return std::string(root != nullptr ? root : ".") + "/" + name;
}

}  // namespace semantic_kiss_testing
