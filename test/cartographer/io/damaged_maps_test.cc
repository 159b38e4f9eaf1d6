// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <fstream>
#include <random>
#include <vector>

#include "cartographer/io/gzip.h"
#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_summary.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/io/record_format.h"
#include "cartographer/io/record_reader.h"
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

  // The serialized messages of the intact file.
  std::vector<std::string> Messages() const {
    std::vector<std::string> messages;
    absl::StatusOr<RecordReader> reader = RecordReader::Open(path_);
    CHECK(ForEachRecord(
              &*reader, [](const CompressedRecord& record) { return record.Decompress(); },
              [&messages](const CompressedRecord&, const std::string& message) {
                messages.push_back(message);
                return absl::OkStatus();
              })
              .ok());
    return messages;
  }

  void WriteMessages(const std::vector<std::string>& messages) const {
    std::string bytes = bytes_.substr(0, kSizeBytes);
    for (const std::string& message : messages) {
      const std::string member = GzipCompress(message);
      for (size_t i = 0; i < kSizeBytes; ++i) {
        bytes.push_back(static_cast<char>(member.size() >> 8 * i));
      }
      bytes += member;
    }
    WriteText(path_, bytes);
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

// Behind an intact checksum: what a hostile program could write. Most changes hit numbers that can
// be anything, so that many maps are read; they must be as good as any other.
TEST_F(DamagedMapsTest, ChangedMessagesGiveErrorsOrMapsThatCanBeUsed) {
  constexpr int kSeed = 20260102, kRounds = 2000, kRoundsPerWrite = 10;
  const std::vector<std::string> messages = Messages();
  std::mt19937 random(kSeed);
  int num_read = 0;
  for (int i = 0; i < kRounds; ++i) {
    std::vector<std::string> changed = messages;
    std::string& message = changed[random() % changed.size()];
    for (int flip = 0; flip <= i % 3; ++flip) {
      char& byte = message[random() % message.size()];
      byte = static_cast<char>(byte ^ 1 << random() % 8);
    }
    WriteMessages(changed);
    const MemoryPeak peak;
    const absl::StatusOr<map::Map> map = ReadMap(path_);
    ASSERT_LT(peak.bytes(), honest_peak_ + (size_t{1} << 20))
        << "round " << i << ", seed " << kSeed;
    ASSERT_EQ(map.ok(), ReadMapSummary(path_).ok());
    if (!map.ok()) continue;
    if (++num_read % kRoundsPerWrite != 0) continue;
    const absl::Status status = WriteMap(*map, rewritten_path_);
    // The one thing that reading need not mind: hits so far apart that no dense grid holds them.
    ASSERT_TRUE(status.ok() || absl::IsInvalidArgument(status)) << status;
    ASSERT_TRUE(!status.ok() || ReadMap(rewritten_path_).ok());
  }
  EXPECT_GT(num_read, kRounds / 10);
  EXPECT_LT(num_read, kRounds * 9 / 10);
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
