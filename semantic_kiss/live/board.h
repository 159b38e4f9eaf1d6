// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LIVE_BOARD_H_
#define SEMANTIC_KISS_LIVE_BOARD_H_

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "semantic_kiss/live/snapshot.h"

namespace semantic_kiss::live {

// Where a run leaves word for those who look on. Any thread may call anything.
class Board {
 public:
  // `now_s` is a steady clock, or a test's own; any thread may call it.
  explicit Board(std::function<double()> now_s) : now_s_(std::move(now_s)) {}

  // Whether somebody asked for a snapshot that is newer than the last one; as cheap as reading a
  // number, to be asked after every scan.
  bool Wanted() const { return wanted_.load(std::memory_order_relaxed); }
  void Put(std::shared_ptr<const Snapshot> snapshot);

  // The last snapshot; nullptr before the first. Asks for a newer one if it is a while old.
  std::shared_ptr<const Snapshot> Look();

  void SetPhase(Phase phase);
  Phase phase() const;

  // Viewers are told apart by names that they choose. Saw() one that looked just now, Served() one
  // that has the report, after which it counts no more.
  void Saw(const std::string& viewer);
  void Served(const std::string& viewer);
  // How many looked within the last seconds and have no report.
  int NumWaiting() const;

 private:
  const std::function<double()> now_s_;
  std::atomic<bool> wanted_{false};
  mutable std::mutex mutex_;
  // All below is guarded by mutex_.
  std::shared_ptr<const Snapshot> snapshot_;
  double put_s_ = 0.;
  Phase phase_ = Phase::kDriving;
  std::map<std::string, double> seen_s_;
};

}  // namespace semantic_kiss::live

#endif  // SEMANTIC_KISS_LIVE_BOARD_H_
