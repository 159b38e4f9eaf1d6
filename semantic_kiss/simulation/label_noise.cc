// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/label_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "semantic_kiss/simulation/hit.h"
#include "semantic_kiss/simulation/material.h"
#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kLargestMistake = 0.5;
constexpr double kBorderRange_m = 0.4;  // neighbours nearer than this touch

// What a class is taken for, likeliest first.
std::vector<uint16_t> Confusions(uint16_t id) {
  switch (id) {
    case label::kCar:
      return {label::kTruck, label::kOtherVehicle, label::kMovingCar};
    case label::kTruck:
      return {label::kOtherVehicle, label::kCar, label::kBuilding};
    case label::kBicycle:
      return {label::kMotorcycle, label::kOtherObject, label::kFence};
    case label::kPerson:
      return {label::kPole, label::kMovingPerson, label::kOtherObject};
    case label::kRoad:
    case label::kLaneMarking:
      return {label::kSidewalk, label::kParking, label::kTerrain};
    case label::kParking:
    case label::kOtherGround:
      return {label::kRoad, label::kSidewalk, label::kTerrain};
    case label::kSidewalk:
      return {label::kRoad, label::kTerrain, label::kParking};
    case label::kTerrain:
      return {label::kSidewalk, label::kVegetation, label::kRoad};
    case label::kBuilding:
      return {label::kFence, label::kVegetation, label::kOtherStructure};
    case label::kFence:
    case label::kOtherStructure:
      return {label::kVegetation, label::kBuilding, label::kOtherObject};
    case label::kVegetation:
      return {label::kFence, label::kTerrain, label::kTrunk};
    case label::kTrunk:
      return {label::kPole, label::kVegetation, label::kFence};
    case label::kPole:
      return {label::kTrunk, label::kTrafficSign, label::kVegetation};
    case label::kTrafficSign:
      return {label::kPole, label::kBuilding, label::kVegetation};
    case label::kMovingCar:
      return {label::kCar, label::kMovingTruck, label::kTruck};
    case label::kMovingTruck:
      return {label::kTruck, label::kMovingCar, label::kBuilding};
    case label::kMovingBicyclist:
      return {label::kBicycle, label::kMovingPerson, label::kPerson};
    case label::kMovingPerson:
      return {label::kPerson, label::kMovingBicyclist, label::kPole};
    default:
      return {label::kFence, label::kVegetation, label::kBuilding};
  }
}

// For each point the label of a touching neighbour of another class, 0 if there is none.
std::vector<uint16_t> BorderLabels(const SimulatedScan& points) {
  std::vector<uint16_t> border(points.size(), 0);
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const SimulatedPoint& a = points[i];
    const SimulatedPoint& b = points[i + 1];
    if (a.beam != b.beam || b.column - a.column > 2 || a.label == b.label) continue;
    if ((a.position - b.position).norm() > kBorderRange_m) continue;
    border[i] = b.label;
    border[i + 1] = a.label;
  }
  return border;
}

// The patch that a point is mistaken with.
uint64_t PatchKey(const SimulatedPoint& point, double patch_m) {
  const auto cell = [&](int axis) {
    return static_cast<uint64_t>(
        static_cast<int64_t>(std::floor(point.true_position[axis] / patch_m)));
  };
  // A small thing is one patch; the ground and walls are cut into many.
  const bool large = point.object == kGroundObject || point.label == label::kBuilding;
  if (!large) return HashKey({point.object});
  return HashKey({point.object, cell(0), cell(1), cell(2), point.label});
}

}  // namespace

void AddLabelNoise(const proto::LabelNoiseOptions& options, uint64_t seed, int scan,
                   SimulatedScan* points) {
  const std::vector<uint16_t> border = BorderLabels(*points);
  const double border_share =
      std::count_if(border.begin(), border.end(), [](uint16_t id) { return id != 0; }) /
      std::max<double>(1., static_cast<double>(points->size()));
  // Borders take up to half of all mistakes; the patches' chances, spread evenly, are the rest.
  const double at_border = std::min({kLargestMistake, options.border_factor() * options.share(),
                                     0.5 * options.share() / std::max(1e-9, border_share)});
  const double inside =
      (options.share() - border_share * at_border) / std::max(1e-9, 1. - border_share);
  const double largest = std::min(2. * inside, kLargestMistake);
  for (size_t i = 0; i < points->size(); ++i) {
    SimulatedPoint& point = (*points)[i];
    const uint64_t patch = PatchKey(point, options.patch_m());
    // Patches do not all begin their mistakes in the same scan.
    const uint64_t period =
        (scan + patch % options.persistence_scans()) / options.persistence_scans();
    Random random(seed, Purpose::kLabel, patch, period);
    const double of_patch = largest * random.Uniform();
    const bool blurred = border[i] != 0 && at_border > of_patch;
    const double chance = blurred ? at_border : of_patch;
    const bool mistaken = random.Chance(chance);
    point.certainty = static_cast<float>(1. - chance);
    if (!mistaken) continue;
    const std::vector<uint16_t> others = Confusions(point.label);
    const int pick = std::min(random.Index(4), random.Index(3));
    point.label = blurred ? border[i] : others[std::min<size_t>(pick, others.size() - 1)];
  }
}

}  // namespace semantic_kiss::simulation
