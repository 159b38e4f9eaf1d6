// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "tbb/global_control.h"
#include "tbb/task_arena.h"

namespace cartographer::common {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

using Chunk = std::pair<size_t, size_t>;

std::vector<Chunk> Chunks(size_t size, size_t chunk_size) {
  return ParallelMapChunks<Chunk>(size, chunk_size,
                                  [](size_t begin, size_t end) { return Chunk(begin, end); });
}

TEST(ParallelMapChunksTest, CutsTheRangeIntoChunksInOrder) {
  EXPECT_THAT(Chunks(0, 4), IsEmpty());
  EXPECT_THAT(Chunks(1, 4), ElementsAre(Pair(0, 1)));
  EXPECT_THAT(Chunks(4, 4), ElementsAre(Pair(0, 4)));
  EXPECT_THAT(Chunks(9, 4), ElementsAre(Pair(0, 4), Pair(4, 8), Pair(8, 9)));
  EXPECT_THAT(Chunks(3, 1), ElementsAre(Pair(0, 1), Pair(1, 2), Pair(2, 3)));
}

TEST(ParallelChunksTest, VisitsEveryElementOnce) {
  for (const size_t size : {0, 1, 7, 1000, 1001}) {
    std::vector<int> visits(size, 0);
    ParallelChunks(size, 8, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(size, 1));
  }
}

// Floating-point addition is not associative, so that the sum tells in which order it was made.
float Sum(const std::vector<float>& values) {
  const std::vector<float> sums =
      ParallelMapChunks<float>(values.size(), 64, [&](size_t begin, size_t end) {
        float sum = 0.f;
        for (size_t i = begin; i < end; ++i) sum += values[i];
        return sum;
      });
  float sum = 0.f;
  for (const float part : sums) sum += part;
  return sum;
}

TEST(ParallelMapChunksTest, GivesTheSameResultOnAnyNumberOfThreads) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE(kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<float> uniform(-1e6f, 1e6f);
  std::vector<float> values(100'000);
  for (float& value : values) value = uniform(random);

  // Four threads even where there are fewer cores.
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena one(1), four(4);
  const float expected = one.execute([&] { return Sum(values); });
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(four.execute([&] { return Sum(values); }), expected);
  }
  // The test could fail: another order gives another sum.
  std::vector<float> shuffled = values;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  EXPECT_NE(Sum(shuffled), expected);
}

}  // namespace
}  // namespace cartographer::common
