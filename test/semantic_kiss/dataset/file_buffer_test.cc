// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/file_buffer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "test/testing/test_files.h"

namespace semantic_kiss::dataset {
namespace {

using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using semantic_kiss_testing::WriteValues;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(FileBufferTest, HoldsTheLatestFileWhateverCameBefore) {
  const TemporaryDirectory directory;
  FileBuffer buffer;
  for (const std::string& text : {std::string("short"), std::string(100000, 'x'), std::string(),
                                  std::string("shorter\0again", 13)}) {
    WriteText(directory / "file", text);
    ASSERT_TRUE(buffer.Read(directory / "file").ok());
    EXPECT_EQ(buffer.text(), text);
    EXPECT_EQ(buffer.size(), text.size());
  }
}

TEST(FileBufferTest, ReadsValuesAndIgnoresARemainder) {
  const TemporaryDirectory directory;
  WriteValues<float>(directory / "file", {1.5f, -2.f});
  FileBuffer buffer;
  ASSERT_TRUE(buffer.Read(directory / "file").ok());
  ASSERT_EQ(buffer.Count<float>(), 2);
  EXPECT_EQ(buffer.As<float>()[1], -2.f);
  WriteText(directory / "file", "12345");
  ASSERT_TRUE(buffer.Read(directory / "file").ok());
  EXPECT_EQ(buffer.Count<uint32_t>(), 1);
}

TEST(FileBufferTest, NamesWhatCannotBeRead) {
  const TemporaryDirectory directory;
  FileBuffer buffer;
  const absl::Status missing = buffer.Read(directory / "missing");
  EXPECT_EQ(missing.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(missing.message()),
              AllOf(HasSubstr(directory / "missing"), HasSubstr("cannot be read")));
  EXPECT_THAT(std::string(buffer.Read(directory.path()).message()),
              HasSubstr(directory.path() + ": is not a regular file"));
}

TEST(FileBufferTest, RefusesAbsurdSizesBeforeTakingMemory) {
  const TemporaryDirectory directory;
  WriteText(directory / "huge", "");
  ASSERT_EQ(truncate((directory / "huge").c_str(), off_t{1} << 40), 0);  // sparse
  FileBuffer buffer;
  EXPECT_THAT(std::string(buffer.Read(directory / "huge").message()),
              HasSubstr("huge: has 1099511627776 bytes; at most 1073741824 are read"));
}

}  // namespace
}  // namespace semantic_kiss::dataset
