// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <fstream>
#include <random>

#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_summary.h"
#include "cartographer/io/map_writer.h"
#include "glog/logging.h"
#include "test/cartographer/io/memory_peak.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using ::testing::HasSubstr;

// For what an error message takes.
constexpr size_t kSlack_bytes = 4096;

class DamagedMapsTest : public ::testing::Test {
 protected:
  DamagedMapsTest() {
    CHECK(WriteMap(SmallMap(2, 20, 4.f), path_).ok());
    bytes_ = ReadText(path_);
    CHECK(ReadMap(path_).ok());  // what is allocated once is not counted below
    const MemoryPeak peak;
    CHECK(ReadMap(path_).ok());
    honest_peak_ = peak.bytes();
  }

  // Reads the file as it is now: it must be refused with an error that names it, or be the same
  // map. Returns whether it was refused.
  bool ReadIsRefused() {
    const MemoryPeak peak;
    const absl::StatusOr<map::Map> map = ReadMap(path_);
    EXPECT_LE(peak.bytes(), 2 * honest_peak_ + kSlack_bytes);
    if (!map.ok()) {
      EXPECT_THAT(std::string(map.status().message()), HasSubstr(path_ + ": "));
      return true;
    }
    EXPECT_TRUE(WriteMap(*map, rewritten_path_).ok());
    EXPECT_EQ(ReadText(rewritten_path_), bytes_);
    return false;
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_ / "map.pbstream";
  std::string rewritten_path_ = directory_ / "again.pbstream";
  std::string bytes_;
  size_t honest_peak_ = 0;
};

TEST_F(DamagedMapsTest, EveryTruncationIsRefused) {
  for (size_t size = bytes_.size(); size-- > 0;) {
    ASSERT_EQ(::truncate(path_.c_str(), static_cast<off_t>(size)), 0);
    ASSERT_TRUE(ReadIsRefused()) << size << " of " << bytes_.size() << " bytes";
    ASSERT_TRUE(size % 16 != 0 || !ReadMapSummary(path_).ok());
  }
}

TEST_F(DamagedMapsTest, BitFlipsAreRefusedOrHarmless) {
  constexpr int kSeed = 20260101, kFlips = 10000;
  std::mt19937 random(kSeed);
  std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
  const auto set = [&file](size_t offset, char byte) {
    file.seekp(static_cast<std::streamoff>(offset)).put(byte).flush();
  };
  int num_harmless = 0;
  for (int i = 0; i < kFlips; ++i) {
    const size_t offset = random() % bytes_.size();
    const int bit = static_cast<int>(random() % 8);
    set(offset, static_cast<char>(bytes_[offset] ^ 1 << bit));
    num_harmless += !ReadIsRefused();
    ASSERT_FALSE(HasFailure()) << "bit " << bit << " of byte " << offset << ", seed " << kSeed;
    set(offset, bytes_[offset]);
  }
  // Only 6 bytes of a gzip header and a flag do not matter.
  EXPECT_GT(num_harmless, 0);
  EXPECT_LT(num_harmless, kFlips / 10);
}

TEST_F(DamagedMapsTest, AppendedBytesAreRefused) {
  for (const std::string& tail :
       {std::string(1, '\0'), std::string(8, '\0'), std::string(100, '\xff'), bytes_}) {
    WriteText(path_, bytes_ + tail);
    EXPECT_TRUE(ReadIsRefused()) << tail.size();
  }
}

}  // namespace
}  // namespace cartographer::io
