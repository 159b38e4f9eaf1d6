// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/matcher_cache.h"

#include <iterator>

#include "glog/logging.h"

namespace cartographer::scan_matching {

std::shared_ptr<const SubmapMatcher> MatcherCache::Get(const submap::SubmapId& id,
                                                       const submap::Submap& submap) {
  CHECK(submap.finished) << "submap " << id.trajectory_id << ", " << id.submap_index;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (auto matcher = Find(id)) return matcher;
  }
  auto built = std::make_shared<const SubmapMatcher>(submap.grid, model_);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++num_built_;
  if (auto matcher = Find(id)) return matcher;
  num_bytes_ += built->num_bytes();
  entries_.push_front({id, built});
  entry_of_id_[id] = entries_.begin();
  KeepWithinBudget();
  return built;
}

void MatcherCache::Remove(const submap::SubmapId& id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto it = entry_of_id_.find(id);
  if (it != entry_of_id_.end()) Drop(it->second);
}

std::shared_ptr<const SubmapMatcher> MatcherCache::Find(const submap::SubmapId& id) {
  const auto it = entry_of_id_.find(id);
  if (it == entry_of_id_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, it->second);
  return it->second->matcher;
}

void MatcherCache::Drop(Entries::iterator entry) {
  num_bytes_ -= entry->matcher->num_bytes();
  entry_of_id_.erase(entry->id);
  entries_.erase(entry);
}

void MatcherCache::KeepWithinBudget() {
  while (num_bytes_ > budget_bytes_) Drop(std::prev(entries_.end()));
}

size_t MatcherCache::num_bytes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return num_bytes_;
}

size_t MatcherCache::num_matchers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.size();
}

size_t MatcherCache::num_built() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return num_built_;
}

}  // namespace cartographer::scan_matching
