// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/localization_error.h"

#include <algorithm>
#include <cmath>

#include "glog/logging.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Rigid3d;

const MappedPlace& NearestPlace(const std::vector<MappedPlace>& places,
                                const Eigen::Vector3d& position) {
  return *std::min_element(places.begin(), places.end(),
                           [&](const MappedPlace& a, const MappedPlace& b) {
                             return (a.world_from_node.translation() - position).squaredNorm() <
                                    (b.world_from_node.translation() - position).squaredNorm();
                           });
}

// `share` of the sorted values are not above it.
double Quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

std::vector<std::optional<LocalizationError>> LocalizationErrors(
    const std::vector<MappedPlace>& places, const std::vector<Rigid3d>& world_from_sensor,
    const std::vector<std::optional<Rigid3d>>& map_from_sensor) {
  CHECK(!places.empty());
  CHECK_EQ(world_from_sensor.size(), map_from_sensor.size());
  std::vector<std::optional<LocalizationError>> errors(map_from_sensor.size());
  for (size_t i = 0; i < errors.size(); ++i) {
    if (!map_from_sensor[i].has_value()) continue;
    const MappedPlace& place = NearestPlace(places, world_from_sensor[i].translation());
    const Rigid3d expected =
        place.map_from_node * place.world_from_node.inverse() * world_from_sensor[i];
    const Rigid3d error = expected.inverse() * *map_from_sensor[i];
    errors[i] = {error.translation().norm(),
                 std::abs(cartographer::transform::Yaw(error.rotation())) * 180. / M_PI};
  }
  return errors;
}

LocalizationMetrics Summarize(const std::vector<std::optional<LocalizationError>>& errors) {
  LocalizationMetrics metrics;
  std::vector<double> positions_m, headings_deg;
  for (const auto& error : errors) {
    if (!error.has_value()) continue;
    positions_m.push_back(error->position_m);
    headings_deg.push_back(error->heading_deg);
    if (error->WrongPlace()) ++metrics.wrong_places;
  }
  if (positions_m.empty()) return metrics;
  std::sort(positions_m.begin(), positions_m.end());
  std::sort(headings_deg.begin(), headings_deg.end());
  metrics.position_median_m = Quantile(positions_m, 0.5);
  metrics.position_p95_m = Quantile(positions_m, 0.95);
  metrics.position_max_m = positions_m.back();
  metrics.heading_median_deg = Quantile(headings_deg, 0.5);
  metrics.heading_p95_deg = Quantile(headings_deg, 0.95);
  return metrics;
}

}  // namespace semantic_kiss::evaluation
