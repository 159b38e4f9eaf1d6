// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/board.h"

#include <algorithm>
#include <iterator>

namespace semantic_kiss::live {
namespace {

// What a person cannot tell from "at once"; it bounds what looking on costs the run.
constexpr double kMinAge_s = 0.4;
// Pages look every second; browsers slow down those that are not seen.
constexpr double kViewerGone_s = 3.;
constexpr size_t kMaxViewers = 64;

}  // namespace

void Board::Put(std::shared_ptr<const Snapshot> snapshot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  snapshot_ = std::move(snapshot);
  put_s_ = now_s_();
  wanted_ = false;
}

std::shared_ptr<const Snapshot> Board::Look() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (snapshot_ == nullptr || now_s_() - put_s_ >= kMinAge_s) wanted_ = true;
  return snapshot_;
}

void Board::SetPhase(Phase phase) {
  const std::lock_guard<std::mutex> lock(mutex_);
  phase_ = phase;
}

Phase Board::phase() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return phase_;
}

void Board::Saw(const std::string& viewer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double now_s = now_s_();
  for (auto it = seen_s_.begin(); it != seen_s_.end();) {
    it = now_s - it->second > kViewerGone_s ? seen_s_.erase(it) : std::next(it);
  }
  if (seen_s_.size() >= kMaxViewers && seen_s_.count(viewer) == 0) return;
  seen_s_[viewer] = now_s;
}

void Board::Served(const std::string& viewer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_s_.erase(viewer);
}

int Board::NumWaiting() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double now_s = now_s_();
  return static_cast<int>(std::count_if(seen_s_.begin(), seen_s_.end(), [&](const auto& viewer) {
    return now_s - viewer.second <= kViewerGone_s;
  }));
}

}  // namespace semantic_kiss::live
