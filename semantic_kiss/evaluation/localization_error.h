// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_EVALUATION_LOCALIZATION_ERROR_H_
#define SEMANTIC_KISS_EVALUATION_LOCALIZATION_ERROR_H_

#include <optional>
#include <vector>

#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss::evaluation {

// A place of a map of which both is known: where the map has it and where it is.
struct MappedPlace {
  cartographer::transform::Rigid3d map_from_node;
  cartographer::transform::Rigid3d world_from_node;
};

struct LocalizationError {
  double position_m = 0.;  // in space
  double heading_deg = 0.;
  // Beyond this a vehicle would be somewhere else.
  bool WrongPlace() const { return position_m > 2. || heading_deg > 5.; }
};

// How far each pose is from where the map has the place at which the vehicle really was: seen from
// the mapped place nearest to it, so that what is wrong with the map as a whole plays no part.
//
//   world_from_sensor   true poses of the localized drive, in the world of the places
//   map_from_sensor     as many estimates (CHECKed); nullopt where there is none
//
// nullopt where there is no estimate. There must be a place (CHECKed).
std::vector<std::optional<LocalizationError>> LocalizationErrors(
    const std::vector<MappedPlace>& places,
    const std::vector<cartographer::transform::Rigid3d>& world_from_sensor,
    const std::vector<std::optional<cartographer::transform::Rigid3d>>& map_from_sensor);

// What tables show of them; absent where no scan was localized.
struct LocalizationMetrics {
  std::optional<double> position_median_m, position_p95_m, position_max_m;
  std::optional<double> heading_median_deg, heading_p95_deg;
  int wrong_places = 0;
};
LocalizationMetrics Summarize(const std::vector<std::optional<LocalizationError>>& errors);

}  // namespace semantic_kiss::evaluation

#endif  // SEMANTIC_KISS_EVALUATION_LOCALIZATION_ERROR_H_
