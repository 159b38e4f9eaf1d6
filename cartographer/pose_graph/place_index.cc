// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_index.h"

#include <algorithm>
#include <utility>

#include "cartographer/common/parallel.h"
#include "cartographer/pose_graph/parabola.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

// Small enough to occupy all threads, large enough that the query stays in the cache.
constexpr size_t kPlacesPerChunk = 32;

template <typename Candidate>
bool IsBetter(const Candidate& a, const Candidate& b) {
  return a.score != b.score ? a.score > b.score : a.submap_id < b.submap_id;
}

}  // namespace

void PlaceIndex::Add(const submap::SubmapId& id, const PlaceDescriptor& descriptor) {
  Remove(id);
  if (descriptor.empty()) return;
  places_[id] = {descriptor.center, descriptor.views[descriptor.views.size() / 2]};
}

void PlaceIndex::Remove(const submap::SubmapId& id) { places_.erase(id); }

double PlaceIndex::CoarseScore(const PlaceDescriptor& query, const Place& place) const {
  const int side = describer_.views_per_side();
  double best = 0.;
  for (int y = 0; y < side; y += 2) {
    for (int x = 0; x < side; x += 2) {
      const BearingSpectrum& view = query.views[y * side + x];
      best = std::max(best, describer_.transform().FindBestHeading(view, place.view).score);
    }
  }
  return best;
}

PlaceCandidate PlaceIndex::Compare(const PlaceDescriptor& query, const submap::SubmapId& id,
                                   const Place& place) const {
  std::vector<BearingTransform::Agreement> agreements;
  for (const BearingSpectrum& view : query.views) {
    agreements.push_back(describer_.transform().FindBestHeading(view, place.view));
  }
  int best = 0;
  for (int i = 1; i < static_cast<int>(agreements.size()); ++i) {
    if (agreements[i].score > agreements[best].score) best = i;
  }
  const int side = describer_.views_per_side();
  // The best point lies between views; at the border of the grid it is taken to be on it.
  const auto between = [&](int place_in_line, int stride) {
    if (place_in_line == 0 || place_in_line == side - 1) return 0.;
    return TopOfParabola(agreements[best - stride].score, agreements[best].score,
                         agreements[best + stride].score);
  };
  const int x = best % side, y = best / side;
  const Eigen::Vector2d steps(x - side / 2 + between(x, 1), y - side / 2 + between(y, side));
  const Eigen::Vector2d viewpoint = query.center + steps * describer_.view_spacing_m();
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
  struct Coarse {
    submap::SubmapId submap_id;
    const Place* place;
    double score;
  };
  std::vector<Coarse> coarse;
  for (const auto& [id, place] : places_) {
    if (!allowed || allowed(id)) coarse.push_back({id, &place, 0.});
  }
  common::ParallelChunks(coarse.size(), kPlacesPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) coarse[i].score = CoarseScore(query, *coarse[i].place);
  });
  const size_t num_kept = std::min(coarse.size(), static_cast<size_t>(max_candidates));
  std::partial_sort(coarse.begin(), coarse.begin() + num_kept, coarse.end(), IsBetter<Coarse>);
  std::vector<PlaceCandidate> candidates;
  for (size_t i = 0; i < num_kept; ++i) {
    candidates.push_back(Compare(query, coarse[i].submap_id, *coarse[i].place));
  }
  std::sort(candidates.begin(), candidates.end(), IsBetter<PlaceCandidate>);
  return candidates;
}

}  // namespace cartographer::pose_graph
