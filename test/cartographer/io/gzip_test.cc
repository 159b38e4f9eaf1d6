// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/gzip.h"

#include <random>

#include "test/cartographer/io/memory_peak.h"

namespace cartographer::io {
namespace {

using ::testing::HasSubstr;

constexpr size_t kLimit = 1 << 26;

std::string RandomBytes(size_t size) {
  std::mt19937 random(3);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

std::string WithClaimedSize(std::string member, uint32_t size) {
  for (int i = 0; i < 4; ++i) member[member.size() - 4 + i] = static_cast<char>(size >> 8 * i);
  return member;
}

TEST(GzipTest, RoundTrip) {
  for (const std::string& data :
       {std::string(), std::string("a"), RandomBytes(100000), std::string(5000000, 'x')}) {
    const std::string member = GzipCompress(data);
    EXPECT_EQ(GzipClaimedSize(member), data.size());
    const auto decompressed = GzipDecompress(member, kLimit);
    ASSERT_TRUE(decompressed.ok()) << decompressed.status();
    EXPECT_EQ(*decompressed, data);
    EXPECT_EQ(GzipCompress(data), member);
  }
}

TEST(GzipTest, DamageIsAnError) {
  const std::string member = GzipCompress(RandomBytes(1000));
  EXPECT_FALSE(GzipDecompress("", kLimit).ok());
  EXPECT_FALSE(GzipDecompress(std::string(20, '\0'), kLimit).ok());
  EXPECT_FALSE(GzipDecompress(member + "x", kLimit).ok());
  EXPECT_FALSE(GzipDecompress(member + member, kLimit).ok());
  for (size_t size = 0; size < member.size(); ++size) {
    EXPECT_EQ(GzipDecompress(member.substr(0, size), kLimit).status().code(),
              absl::StatusCode::kDataLoss);
  }
}

TEST(GzipTest, TheLimitHoldsBeforeAnythingIsDecompressed) {
  const std::string bomb = GzipCompress(std::string(1000001, '\0'));
  const MemoryPeak peak;
  const auto decompressed = GzipDecompress(bomb, 1000000);
  EXPECT_THAT(std::string(decompressed.status().message()),
              HasSubstr("decompresses to 1000001 bytes, more than the 1000000 allowed"));
  EXPECT_LT(peak.bytes(), 10000u);
}

TEST(GzipTest, LiesAboutTheSizeCostNoMemory) {
  const std::string member = GzipCompress(RandomBytes(1000));
  for (const uint32_t size : {0u, 999u, 1001u, 50'000u, 1'000'000u, 60'000'000u}) {
    const MemoryPeak peak;
    EXPECT_FALSE(GzipDecompress(WithClaimedSize(member, size), kLimit).ok()) << size;
    EXPECT_LT(peak.bytes(), 100'000u) << size;
  }
}

}  // namespace
}  // namespace cartographer::io
