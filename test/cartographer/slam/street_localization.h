// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_SLAM_STREET_LOCALIZATION_H_
#define TEST_CARTOGRAPHER_SLAM_STREET_LOCALIZATION_H_

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cartographer/map/map.h"
#include "cartographer/slam/relocalizer.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::slam {

// A drive, scan by scan, two scans a metre; every second one becomes a node.
struct StreetVisit {
  std::vector<transform::Rigid3d> truth;  // street_from_sensor
  // What an odometry that knows nothing of jumps would make of it: its own frame, other than the
  // street's. As long as `truth`.
  std::vector<transform::Rigid3d> odometry;
  std::function<bool(int scan)> blind = [](int) { return false; };  // where the scan is empty
  int street = 1;                                                   // seed of what is built there
};

// Appends `meters` of driving straight on from (x, y) of the street, towards larger x or smaller.
void DriveOn(double x, double y, bool forwards, int meters, StreetVisit* visit);

// What localization was like.
struct Localized {
  std::vector<LocalizedScan> scans;
  std::vector<std::optional<transform::Rigid3d>> smoothed;
  int num_odometries = 0;  // that were begun
  size_t num_nodes = 0;    // in the graph, in the end

  // The first scan at or after `from` that has the state; -1 if none has.
  int FirstWith(LocalizationState state, int from = 0) const;
};

// A map of the street of seed 1, from x = -15 to 15; its frame is the street's.
const map::Map& MapOfStreet();

// Runs the relocalizer over the visit, as shipped but for `changes` to RELOCALIZATION in Lua;
// `prepare` may tell it where the drive begins.
Localized Localize(
    const map::Map& map, const StreetVisit& visit, const std::string& changes = "",
    const std::function<void(Relocalizer*)>& prepare = [](Relocalizer*) {});

}  // namespace cartographer::slam

#endif  // TEST_CARTOGRAPHER_SLAM_STREET_LOCALIZATION_H_
