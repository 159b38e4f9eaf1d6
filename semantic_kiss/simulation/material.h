// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_MATERIAL_H_
#define SEMANTIC_KISS_SIMULATION_MATERIAL_H_

#include <cstdint>

// What surfaces are made of and how SemanticKITTI's files number them.
namespace semantic_kiss::simulation {

// Ids in SemanticKITTI's label files.
namespace label {
inline constexpr uint16_t kUnlabeled = 0, kCar = 10, kBicycle = 11, kMotorcycle = 15, kTruck = 18,
                          kOtherVehicle = 20, kPerson = 30, kRoad = 40, kParking = 44,
                          kSidewalk = 48, kOtherGround = 49, kBuilding = 50, kFence = 51,
                          kOtherStructure = 52, kLaneMarking = 60, kVegetation = 70, kTrunk = 71,
                          kTerrain = 72, kPole = 80, kTrafficSign = 81, kOtherObject = 99,
                          kMovingCar = 252, kMovingBicyclist = 253, kMovingPerson = 254,
                          kMovingTruck = 258;
}  // namespace label

struct Material {
  uint16_t label = label::kUnlabeled;
  float remission = 0.3f;         // of a surface that faces the sensor, in [0, 1]
  float remission_spread = 0.1f;  // standard deviation from object to object and point to point
  float mirror = 0.f;             // share of rays that are reflected away or go through: glass
};

namespace material {
inline constexpr Material kAsphalt{label::kRoad, 0.23f, 0.07f};
inline constexpr Material kMarking{label::kLaneMarking, 0.45f, 0.1f};
inline constexpr Material kParking{label::kParking, 0.29f, 0.08f};
inline constexpr Material kPavement{label::kSidewalk, 0.32f, 0.08f};
inline constexpr Material kYard{label::kOtherGround, 0.3f, 0.08f};
inline constexpr Material kGrass{label::kTerrain, 0.34f, 0.1f};
inline constexpr Material kWall{label::kBuilding, 0.42f, 0.12f};
inline constexpr Material kGlass{label::kBuilding, 0.15f, 0.1f, 0.3f};
inline constexpr Material kRoof{label::kBuilding, 0.25f, 0.08f};
inline constexpr Material kFence{label::kFence, 0.32f, 0.12f};
inline constexpr Material kGuardRail{label::kFence, 0.5f, 0.1f};
inline constexpr Material kGardenWall{label::kOtherStructure, 0.36f, 0.1f};
inline constexpr Material kLeaves{label::kVegetation, 0.34f, 0.12f};
inline constexpr Material kBark{label::kTrunk, 0.3f, 0.08f};
inline constexpr Material kPole{label::kPole, 0.25f, 0.1f};
inline constexpr Material kSign{label::kTrafficSign, 0.85f, 0.1f};
inline constexpr Material kBin{label::kOtherObject, 0.3f, 0.15f};
inline constexpr Material kCarPaint{label::kCar, 0.25f, 0.15f, 0.12f};
inline constexpr Material kCarGlass{label::kCar, 0.08f, 0.05f, 0.85f};
inline constexpr Material kTruckBody{label::kTruck, 0.4f, 0.15f};
inline constexpr Material kBicycle{label::kBicycle, 0.25f, 0.1f};
inline constexpr Material kPerson{label::kPerson, 0.3f, 0.15f};
inline constexpr Material kMovingCarPaint{label::kMovingCar, 0.25f, 0.15f, 0.12f};
inline constexpr Material kMovingCarGlass{label::kMovingCar, 0.08f, 0.05f, 0.85f};
inline constexpr Material kMovingTruck{label::kMovingTruck, 0.4f, 0.15f};
inline constexpr Material kMovingBicyclist{label::kMovingBicyclist, 0.3f, 0.12f};
inline constexpr Material kMovingPerson{label::kMovingPerson, 0.3f, 0.15f};
}  // namespace material

// Whether another day may find the thing elsewhere or gone.
constexpr bool IsMovable(uint16_t id) {
  return (id >= label::kCar && id <= label::kPerson + 2) || id >= label::kMovingCar;
}

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_MATERIAL_H_
