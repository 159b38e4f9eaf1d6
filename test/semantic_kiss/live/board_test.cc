// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/board.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace semantic_kiss::live {
namespace {

std::shared_ptr<const Snapshot> SnapshotOf(int done) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->done = done;
  snapshot->path.assign(done, Eigen::Vector2d(done, 0.));
  return snapshot;
}

TEST(BoardTest, NothingIsWantedUntilSomebodyLooks) {
  double now_s = 0.;
  Board board([&] { return now_s; });
  EXPECT_FALSE(board.Wanted());
  EXPECT_EQ(board.Look(), nullptr);
  EXPECT_TRUE(board.Wanted());
  board.Put(SnapshotOf(1));
  EXPECT_FALSE(board.Wanted());
  // One that is fresh will do, however many look.
  EXPECT_EQ(board.Look()->done, 1);
  EXPECT_FALSE(board.Wanted());
  now_s = 1.;
  EXPECT_EQ(board.Look()->done, 1);
  EXPECT_TRUE(board.Wanted());
}

TEST(BoardTest, CountsThoseWhoStillWaitForTheReport) {
  double now_s = 0.;
  Board board([&] { return now_s; });
  EXPECT_EQ(board.NumWaiting(), 0);
  board.Saw("a");
  board.Saw("b");
  board.Saw("a");
  EXPECT_EQ(board.NumWaiting(), 2);
  board.Served("a");
  EXPECT_EQ(board.NumWaiting(), 1);
  now_s = 60.;  // gone
  EXPECT_EQ(board.NumWaiting(), 0);
  board.Saw("b");
  EXPECT_EQ(board.NumWaiting(), 1);
}

TEST(BoardTest, ManyViewersDoNotFillTheMemory) {
  Board board([] { return 0.; });
  for (int i = 0; i < 1000; ++i) board.Saw(std::to_string(i));
  EXPECT_EQ(board.NumWaiting(), 64);
}

TEST(BoardTest, ViewersWhoLeftMakeRoom) {
  double now_s = 0.;
  Board board([&] { return now_s; });
  for (int i = 0; i < 64; ++i) board.Saw(std::to_string(i));
  now_s = 3600.;
  board.Saw("late");
  EXPECT_EQ(board.NumWaiting(), 1);
}

TEST(BoardTest, ViewersOnOtherThreadsSeeWholeSnapshotsInOrder) {
  constexpr int kSnapshots = 2000;
  std::atomic<int> clock{0};
  Board board([&] { return 1. * ++clock; });
  std::atomic<bool> ended{false};
  std::vector<std::thread> viewers;
  for (int i = 0; i < 3; ++i) {
    viewers.emplace_back([&, i] {
      int last = 0;
      while (!ended) {
        board.Saw(std::to_string(i));
        const auto snapshot = board.Look();
        if (snapshot == nullptr) continue;
        EXPECT_GE(snapshot->done, last);
        EXPECT_EQ(snapshot->path.size(), snapshot->done);
        last = snapshot->done;
      }
      EXPECT_EQ(board.phase(), Phase::kDone);
    });
  }
  for (int done = 1; done <= kSnapshots;) {
    if (board.Wanted()) board.Put(SnapshotOf(done++));
  }
  board.SetPhase(Phase::kDone);
  ended = true;
  for (std::thread& viewer : viewers) viewer.join();
  EXPECT_EQ(board.Look()->done, kSnapshots);
}

}  // namespace
}  // namespace semantic_kiss::live
