// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SCAN_MATCHING_MATCHER_CACHE_H_
#define CARTOGRAPHER_SCAN_MATCHING_MATCHER_CACHE_H_

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>

#include "cartographer/scan_matching/score_model.h"
#include "cartographer/scan_matching/submap_matcher.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/submap.h"

namespace cartographer::scan_matching {

// The matchers of the submaps that were matched lately. Each is built when it is first asked for;
// the ones that were not asked for longest are dropped as soon as all together take more than a
// budget, and built again if they are needed again. Results do not depend on what is in the cache.
//
// Safe between threads. Two that ask for the same matcher at the same time may both build it; one
// of the two is kept. (Making one wait for the other could lock up a thread that took on the
// waiting task while it was building.)
class MatcherCache {
 public:
  MatcherCache(const ScoreModel& model, size_t budget_bytes)
      : model_(model), budget_bytes_(budget_bytes) {}

  // The matcher of a finished submap (CHECKed; a submap that grows would go stale). It lives as
  // long as anyone holds it, dropped or not. A matcher larger than the whole budget is not kept.
  std::shared_ptr<const SubmapMatcher> Get(const submap::SubmapId& id,
                                           const submap::Submap& submap);

  // Forgets a submap that was trimmed.
  void Remove(const submap::SubmapId& id);

  size_t num_bytes() const;
  size_t num_matchers() const;
  // Matchers built so far.
  size_t num_built() const;

 private:
  struct Entry {
    submap::SubmapId id;
    std::shared_ptr<const SubmapMatcher> matcher;
  };
  using Entries = std::list<Entry>;

  // All three with mutex_ held.
  std::shared_ptr<const SubmapMatcher> Find(const submap::SubmapId& id);
  void Drop(Entries::iterator entry);
  void KeepWithinBudget();

  const ScoreModel model_;
  const size_t budget_bytes_;

  mutable std::mutex mutex_;
  Entries entries_;  // asked for last first
  std::map<submap::SubmapId, Entries::iterator> entry_of_id_;
  size_t num_bytes_ = 0;
  size_t num_built_ = 0;
};

}  // namespace cartographer::scan_matching

#endif  // CARTOGRAPHER_SCAN_MATCHING_MATCHER_CACHE_H_
