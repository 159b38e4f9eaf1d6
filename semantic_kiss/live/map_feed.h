// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LIVE_MAP_FEED_H_
#define SEMANTIC_KISS_LIVE_MAP_FEED_H_

#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "semantic_kiss/live/picture.h"

namespace semantic_kiss::live {

// Keeps the picture up to date for several viewers, at a small share of the machine's time: after
// each drawing it rests many times as long. Any thread may call anything.
class MapFeed {
 public:
  MapFeed(const cartographer::sensor::LabelSet& labels, std::function<double()> now_s)
      : now_s_(std::move(now_s)), picture_(labels) {}

  // Draws what is new, if it has rested enough.
  void Update(const Snapshot& snapshot);

  // {version, min_x, max_y, resolution, width, height} of what Png() returns; null before anything
  // is drawn.
  nlohmann::ordered_json Description() const;
  std::string Png() const;

 private:
  const std::function<double()> now_s_;
  mutable std::mutex mutex_;
  // All below is guarded by mutex_.
  Picture picture_;
  std::string png_;
  int version_ = 0;
  double rests_until_s_ = 0.;
};

}  // namespace semantic_kiss::live

#endif  // SEMANTIC_KISS_LIVE_MAP_FEED_H_
