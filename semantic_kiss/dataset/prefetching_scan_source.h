// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_DATASET_PREFETCHING_SCAN_SOURCE_H_
#define SEMANTIC_KISS_DATASET_PREFETCHING_SCAN_SOURCE_H_

#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "semantic_kiss/dataset/scan_source.h"

namespace semantic_kiss::dataset {

// Another source, read ahead: while the caller works on a scan, one thread in the background loads
// the next ones. What Read() returns, errors included, and what unknown_label_ids() counts is
// exactly what `source` alone would give for the same calls, whatever the timing. So is what it
// throws, for want of memory: that must not end the program on a thread where nobody catches it.
//
// Scans are meant to be read in order; Read() of any other scan than the next one works, but
// throws away what was loaded ahead.
class PrefetchingScanSource : public ScanSource {
 public:
  explicit PrefetchingScanSource(std::unique_ptr<ScanSource> source);
  ~PrefetchingScanSource() override;

  PrefetchingScanSource(const PrefetchingScanSource&) = delete;
  PrefetchingScanSource& operator=(const PrefetchingScanSource&) = delete;

  int size() const override { return source_->size(); }
  absl::StatusOr<cartographer::sensor::LabeledScan> Read(int index) override;
  const cartographer::sensor::LabelSet& labels() const override { return source_->labels(); }
  const std::optional<std::vector<cartographer::transform::Rigid3d>>& ground_truth()
      const override {
    return source_->ground_truth();
  }
  const std::optional<cartographer::transform::Rigid3d>& camera_from_sensor() const override {
    return source_->camera_from_sensor();
  }
  const UnknownLabelIds& unknown_label_ids() const override { return unknown_ids_; }
  const std::vector<std::string>& notes() const override { return source_->notes(); }

 private:
  struct Loaded {
    absl::StatusOr<cartographer::sensor::LabeledScan> scan;
    UnknownLabelIds unknown_ids;  // those of this scan
    std::exception_ptr thrown;    // in place of a scan
  };

  void LoadInBackground();
  Loaded Load(int index);

  const std::unique_ptr<ScanSource> source_;  // Read() is called by the background thread alone
  UnknownLabelIds unknown_ids_;               // of the scans that were handed out

  std::mutex mutex_;
  std::condition_variable changed_;
  // The rest is guarded by mutex_. loaded_ holds the scans from next_to_read_ on, in order; the
  // thread goes on with next_to_load_ (size(): with nothing).
  std::deque<Loaded> loaded_;
  int next_to_read_ = -1;
  int next_to_load_;
  int restarts_ = 0;  // what was begun before the latest restart is thrown away
  bool stopping_ = false;

  std::thread thread_;  // last: it uses all of the above
};

}  // namespace semantic_kiss::dataset

#endif  // SEMANTIC_KISS_DATASET_PREFETCHING_SCAN_SOURCE_H_
