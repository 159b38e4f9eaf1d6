// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_SUBMAP_SUCCESSION_H_
#define CARTOGRAPHER_SUBMAP_SUBMAP_SUCCESSION_H_

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "cartographer/submap/submap.h"

namespace cartographer::submap {

// When submaps begin and end: at most two grow, an older one, in which the newer one's place will
// be known, and the newer one, which carries on when the older is full. Growing is a struct with a
// member `std::shared_ptr<Submap> submap`, whose `num_scans` its owner counts.
template <typename Growing>
class SubmapSuccession {
 public:
  explicit SubmapSuccession(int scans_per_submap) : scans_per_submap_(scans_per_submap) {}

  // Whether one is to begin before the next scan goes in: there is none, or the newest is half
  // full.
  bool NeedsNew() const {
    return growing_.empty() || growing_.back().submap->num_scans >= (scans_per_submap_ + 1) / 2;
  }
  void Begin(Growing growing) {
    growing_.push_back(std::move(growing));
    ++num_begun_;
  }

  // Those that grow, oldest first.
  std::deque<Growing>& growing() { return growing_; }
  const std::deque<Growing>& growing() const { return growing_; }

  // The same by their running number.
  std::map<int, std::shared_ptr<const Submap>> Submaps() const {
    std::map<int, std::shared_ptr<const Submap>> submaps;
    int index = num_begun_ - static_cast<int>(growing_.size());
    for (const Growing& growing : growing_) submaps.emplace(index++, growing.submap);
    return submaps;
  }

  // Takes out the oldest, if it is full.
  std::optional<Growing> TakeFull() {
    if (growing_.empty() || growing_.front().submap->num_scans < scans_per_submap_) {
      return std::nullopt;
    }
    std::optional<Growing> full(std::move(growing_.front()));
    growing_.pop_front();
    return full;
  }

 private:
  const int scans_per_submap_;
  std::deque<Growing> growing_;
  int num_begun_ = 0;
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_SUBMAP_SUCCESSION_H_
