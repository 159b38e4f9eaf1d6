// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/prefetching_scan_source.h"

#include <utility>

#include "glog/logging.h"

namespace semantic_kiss::dataset {
namespace {

// Scans in memory beyond the one that the caller has: one would do if every scan took as long as
// the next; the second bridges a slow disk or a quick scan.
constexpr int kScansAhead = 2;

UnknownLabelIds Difference(const UnknownLabelIds& after, const UnknownLabelIds& before) {
  UnknownLabelIds difference = after;
  for (const auto& [id, count] : before) {
    if ((difference[id] -= count) == 0) difference.erase(id);
  }
  return difference;
}

}  // namespace

PrefetchingScanSource::PrefetchingScanSource(std::unique_ptr<ScanSource> source)
    : source_(std::move(source)),
      next_to_load_(source_->size()),
      thread_([this] { LoadInBackground(); }) {}

PrefetchingScanSource::~PrefetchingScanSource() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

absl::StatusOr<cartographer::sensor::LabeledScan> PrefetchingScanSource::Read(int index) {
  CHECK_GE(index, 0);
  CHECK_LT(index, size());
  std::unique_lock<std::mutex> lock(mutex_);
  if (index != next_to_read_) {
    loaded_.clear();
    next_to_load_ = index;
    ++restarts_;
    changed_.notify_all();
  }
  changed_.wait(lock, [this] { return !loaded_.empty(); });
  Loaded loaded = std::move(loaded_.front());
  loaded_.pop_front();
  next_to_read_ = index + 1;
  changed_.notify_all();
  for (const auto& [id, count] : loaded.unknown_ids) unknown_ids_[id] += count;
  if (loaded.thrown != nullptr) std::rethrow_exception(loaded.thrown);
  return std::move(loaded.scan);
}

void PrefetchingScanSource::LoadInBackground() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] {
      return stopping_ || (next_to_load_ < size() && loaded_.size() < kScansAhead);
    });
    if (stopping_) return;
    const int index = next_to_load_++;
    const int restarts = restarts_;
    lock.unlock();
    Loaded loaded = Load(index);
    lock.lock();
    if (restarts != restarts_) continue;
    loaded_.push_back(std::move(loaded));
    changed_.notify_all();
  }
}

PrefetchingScanSource::Loaded PrefetchingScanSource::Load(int index) try {
  const UnknownLabelIds before = source_->unknown_label_ids();
  absl::StatusOr<cartographer::sensor::LabeledScan> scan = source_->Read(index);
  return {std::move(scan), Difference(source_->unknown_label_ids(), before), nullptr};
} catch (...) {
  return {absl::UnknownError("thrown"), {}, std::current_exception()};
}

}  // namespace semantic_kiss::dataset
