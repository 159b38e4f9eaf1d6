// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_index.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cartographer/common/parallel.h"
#include "glog/logging.h"

namespace cartographer::pose_graph {
namespace {

constexpr size_t kPlacesPerChunk = 16;

struct Agreement {
  double yaw_rad;
  double score;
};

// The heading at which two descriptors agree best: the correlation over all headings, by way of
// its Fourier coefficients, of which each is the sum over the rows of target * conj(query).
Agreement Compare(const PlaceDescriptor& query, const PlaceDescriptor& target, int num_harmonics) {
  std::vector<float> real(num_harmonics, 0.f), imaginary(num_harmonics, 0.f);
  for (size_t row = 0; row < query.coefficients.size(); row += 2 * num_harmonics) {
    const float* const q = &query.coefficients[row];
    const float* const t = &target.coefficients[row];
    for (int k = 0; k < num_harmonics; ++k) {
      real[k] += t[2 * k] * q[2 * k] + t[2 * k + 1] * q[2 * k + 1];
      imaginary[k] += t[2 * k + 1] * q[2 * k] - t[2 * k] * q[2 * k + 1];
    }
  }
  const int num_headings = 8 * num_harmonics;
  Agreement best{0., -2.};
  for (int h = 0; h < num_headings; ++h) {
    const double yaw = 2. * M_PI * h / num_headings;
    double sum = 0.;
    for (int k = 0; k < num_harmonics; ++k) {
      sum += real[k] * std::cos((k + 1) * yaw) - imaginary[k] * std::sin((k + 1) * yaw);
    }
    if (sum > best.score) best = {yaw, sum};
  }
  best.yaw_rad = std::remainder(best.yaw_rad, 2. * M_PI);
  return best;
}

}  // namespace

void PlaceIndex::Add(const submap::SubmapId& id, PlaceDescriptor descriptor) {
  descriptors_[id] = std::move(descriptor);
}

void PlaceIndex::Remove(const submap::SubmapId& id) { descriptors_.erase(id); }

const PlaceDescriptor* PlaceIndex::Find(const submap::SubmapId& id) const {
  const auto it = descriptors_.find(id);
  return it == descriptors_.end() ? nullptr : &it->second;
}

std::vector<PlaceCandidate> PlaceIndex::Find(
    const PlaceDescriptor& query, int max_candidates,
    const std::function<bool(const submap::SubmapId&)>& allowed) const {
  CHECK_GE(max_candidates, 0);
  if (query.empty()) return {};
  std::vector<std::pair<submap::SubmapId, const PlaceDescriptor*>> places;
  for (const auto& [id, descriptor] : descriptors_) {
    if (!descriptor.empty() && (!allowed || allowed(id))) places.emplace_back(id, &descriptor);
  }
  std::vector<PlaceCandidate> candidates(places.size());
  common::ParallelChunks(places.size(), kPlacesPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const PlaceDescriptor& target = *places[i].second;
      const Agreement agreement = Compare(query, target, describer_.num_harmonics());
      const Eigen::Vector2d query_center = Eigen::Rotation2Dd(agreement.yaw_rad) * query.center;
      candidates[i] = {
          places[i].first, {target.center - query_center, agreement.yaw_rad}, agreement.score};
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
