// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_TESTING_TEST_FILES_H_
#define TEST_TESTING_TEST_FILES_H_

#include <optional>
#include <string>
#include <vector>

namespace semantic_kiss_testing {

// A directory of its own for a test, gone with the object.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::string& path() const { return path_; }
  // The path of `name` in it.
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

// Writes a file, replacing an existing one and making the directories above it. CHECK-fails if
// that does not work.
void WriteText(const std::string& path, const std::string& text);

// All bytes of a file. CHECK-fails if it cannot be read.
std::string ReadText(const std::string& path);

// As WriteText() for binary values in the machine's (little-endian) order.
template <typename T>
void WriteValues(const std::string& path, const std::vector<T>& values) {
  WriteText(path,
            std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
}

// The real data that some tests compare with: $SEMANTIC_KISS_DATA, else ../shared/data beside the
// source tree; nullopt, after a loud message, where there is none. Tests are then to GTEST_SKIP().
std::optional<std::string> RealDataDirectory();

// Path of a file of the source tree.
std::string SourceFile(const std::string& name);

}  // namespace semantic_kiss_testing

#endif  // TEST_TESTING_TEST_FILES_H_
