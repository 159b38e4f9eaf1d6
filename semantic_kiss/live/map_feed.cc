// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/map_feed.h"

#include "cartographer/common/cpu_time.h"

namespace semantic_kiss::live {
namespace {

using cartographer::common::ThreadCpuSeconds;

// Drawing takes at most one part in so many of one core.
constexpr double kRestPerWork = 20.;

}  // namespace

void MapFeed::Update(const Snapshot& snapshot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (version_ > 0 && now_s_() < rests_until_s_) return;
  const double begin_s = ThreadCpuSeconds();
  if (!picture_.Draw(snapshot)) return;
  png_ = picture_.Png();
  if (png_.empty()) return;
  ++version_;
  rests_until_s_ = now_s_() + kRestPerWork * (ThreadCpuSeconds() - begin_s);
}

nlohmann::ordered_json MapFeed::Description() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (version_ == 0) return {};
  const cartographer::io::RasterFrame& frame = picture_.frame();
  return {{"version", version_},  {"min_x", frame.min_x},
          {"max_y", frame.max_y}, {"resolution", frame.resolution_m},
          {"width", frame.width}, {"height", frame.height}};
}

std::string MapFeed::Png() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return png_;
}

}  // namespace semantic_kiss::live
