// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/submap_matcher.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cartographer/common/parallel.h"
#include "cartographer/scan_matching/score_layers.h"

namespace cartographer::scan_matching {
namespace {

// What a score of 1 is in the integers of the search.
double FullScore(const MatchingScan& scan) {
  return static_cast<double>(scan.total_weight()) * ScoreModel::kFullAgreement;
}

int32_t NumeratorOf(double min_score, const MatchingScan& scan) {
  const double numerator = std::ceil(min_score * FullScore(scan));
  return static_cast<int32_t>(
      std::clamp(numerator, 0., double{std::numeric_limits<int32_t>::max()}));
}

}  // namespace

SubmapMatcher::SubmapMatcher(const submap::SemanticGrid& grid, const ScoreModel& model)
    : resolution_m_(grid.resolution_m()), box_(grid.Bounds()), pyramid_(grid, model) {
  box_.min = box_.min.max(-kMaxCell);
  box_.max = box_.max.min(kMaxCell);
}

std::optional<Match> SubmapMatcher::MatchInWindow(const MatchingScan& scan, const PlanarPose& guess,
                                                  const SearchWindow& window, double min_score,
                                                  SharedScore* shared) const {
  const SearchSpace space = SpaceAround(guess, window, resolution_m_, scan.radius_m());
  return Find(scan, space, min_score, shared);
}

std::optional<Match> SubmapMatcher::MatchInWholeSubmap(const MatchingScan& scan, double min_score,
                                                       SharedScore* shared) const {
  return Find(scan, WholeSpace(box_, resolution_m_, scan.radius_m()), min_score, shared);
}

std::optional<Match> SubmapMatcher::Find(const MatchingScan& scan, const SearchSpace& space,
                                         double min_score, SharedScore* shared) const {
  const std::optional<BestPose> best =
      FindBestPose(pyramid_, scan, space, resolution_m_, NumeratorOf(min_score, scan), shared);
  if (!best.has_value()) return std::nullopt;
  return Match{space.PoseAt(best->yaw, best->shift, resolution_m_), best->score / FullScore(scan)};
}

double SubmapMatcher::ScoreAt(const MatchingScan& scan, const PlanarPose& submap_from_node) const {
  if (scan.empty()) return 0.;
  int64_t sum = 0;
  const ScanCells at_pose = scan.CellsAt(submap_from_node, resolution_m_);
  for (const ScanCells::Layer& layer : at_pose.layers) {
    const int plane = pyramid_.PlaneOf(0, layer.layer);
    for (size_t i = layer.begin; i < layer.end; ++i) {
      const ScanCell& cell = at_pose.cells[i];
      sum += int64_t{cell.weight} * pyramid_.level(0).BoundAt(plane, {cell.x, cell.y}, {0, 0});
    }
  }
  return static_cast<double>(sum) / FullScore(scan);
}

std::optional<MatchInAreas> MatchInAny(const std::vector<SearchArea>& areas,
                                       const MatchingScan& scan, double min_score) {
  SharedScore shared;
  std::vector<std::optional<Match>> matches(areas.size());
  common::ParallelChunks(areas.size(), 1, [&](size_t i, size_t) {
    const auto& [matcher, around] = areas[i];
    matches[i] = around.has_value() ? matcher->MatchInWindow(scan, around->guess, around->window,
                                                             min_score, &shared)
                                    : matcher->MatchInWholeSubmap(scan, min_score, &shared);
  });
  std::optional<MatchInAreas> best;
  for (size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].has_value()) continue;
    if (!best.has_value() || matches[i]->score > best->match.score) best = {i, *matches[i]};
  }
  return best;
}

}  // namespace cartographer::scan_matching
