// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_index.h"

#include <algorithm>
#include <utility>

#include "cartographer/common/parallel.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

// Small enough to occupy all threads, large enough that the query stays in the cache.
constexpr size_t kPlacesPerChunk = 32;

// Where between the views the agreement is best, in steps from the best view: by a parabola along
// an axis, if there is a view to both sides.
double StepBetweenViews(const std::vector<BearingTransform::Agreement>& agreements, int best,
                        int place_in_row, int views_per_side, int stride) {
  if (place_in_row == 0 || place_in_row == views_per_side - 1) return 0.;
  const double middle = agreements[best].score;
  const double before = agreements[best - stride].score, after = agreements[best + stride].score;
  const double curvature = before - 2. * middle + after;
  return curvature < 0. ? 0.5 * (before - after) / curvature : 0.;
}

}  // namespace

void PlaceIndex::Add(const submap::SubmapId& id, const PlaceDescriptor& descriptor) {
  Remove(id);
  if (descriptor.empty()) return;
  places_[id] = {descriptor.center, descriptor.views[descriptor.views.size() / 2]};
}

void PlaceIndex::Remove(const submap::SubmapId& id) { places_.erase(id); }

PlaceCandidate PlaceIndex::Compare(const PlaceDescriptor& query, const submap::SubmapId& id,
                                   const Place& place) const {
  std::vector<BearingTransform::Agreement> agreements;
  agreements.reserve(query.views.size());
  for (const BearingSpectrum& view : query.views) {
    agreements.push_back(describer_.transform().FindBestHeading(view, place.view));
  }
  int best = 0;
  for (int i = 1; i < static_cast<int>(agreements.size()); ++i) {
    if (agreements[i].score > agreements[best].score) best = i;
  }
  const int side = describer_.views_per_side();
  const int x = best % side, y = best / side;
  const Eigen::Vector2d steps(x - side / 2 + StepBetweenViews(agreements, best, x, side, 1),
                              y - side / 2 + StepBetweenViews(agreements, best, y, side, side));
  const Eigen::Vector2d viewpoint = query.center + steps * describer_.shift_m();
  const double yaw_rad = agreements[best].yaw_rad;
  return {id,
          {place.center - Eigen::Rotation2Dd(yaw_rad) * viewpoint, yaw_rad},
          agreements[best].score};
}

std::vector<PlaceCandidate> PlaceIndex::Find(
    const PlaceDescriptor& query, int max_candidates,
    const std::function<bool(const submap::SubmapId&)>& allowed) const {
  CHECK_GE(max_candidates, 0);
  if (query.empty()) return {};
  std::vector<const std::pair<const submap::SubmapId, Place>*> places;
  for (const auto& place : places_) {
    if (!allowed || allowed(place.first)) places.push_back(&place);
  }
  std::vector<PlaceCandidate> candidates(places.size());
  common::ParallelChunks(places.size(), kPlacesPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      candidates[i] = Compare(query, places[i]->first, places[i]->second);
    }
  });
  const size_t num_kept = std::min(candidates.size(), static_cast<size_t>(max_candidates));
  std::partial_sort(candidates.begin(), candidates.begin() + num_kept, candidates.end(),
                    [](const PlaceCandidate& a, const PlaceCandidate& b) {
                      return a.score != b.score ? a.score > b.score : a.submap_id < b.submap_id;
                    });
  candidates.resize(num_kept);
  return candidates;
}

}  // namespace cartographer::pose_graph
