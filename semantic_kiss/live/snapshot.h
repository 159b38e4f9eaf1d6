// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LIVE_SNAPSHOT_H_
#define SEMANTIC_KISS_LIVE_SNAPSHOT_H_

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cartographer/submap/id.h"
#include "cartographer/submap/placed.h"

namespace semantic_kiss::live {

// How far a run has come at one moment: a value that nothing changes any more, since of submaps,
// which are shared, it holds the finished ones alone.
struct Snapshot {
  int done = 0;   // scans
  int total = 0;  // of so many
  double elapsed_s = 0.;
  std::optional<double> error_m;  // of the current position, with ground truth
  double memory_mib = 0.;         // held at the moment
  int num_nodes = 0;
  std::map<std::string, int> outcomes;  // of the odometry
  int num_candidates = 0;               // for loop closure, judged so far

  struct Stage {
    std::string name;
    double mean_ms = 0.;
    double total_s = 0.;
  };
  std::vector<Stage> stages;

  std::vector<Eigen::Vector2d> path;  // positions of the drive's nodes [m], map frame
  struct Closure {
    Eigen::Vector2d node, submap;  // [m], map frame
  };
  std::vector<Closure> closures;
  std::map<cartographer::submap::SubmapId, cartographer::submap::PlacedSubmap> submaps;  // finished
};

// What a run is about.
enum class Phase {
  kDriving,
  kConcluding,  // the last loop closures, and files
  kDone,        // the files are there
  kStopped      // the same, for the scans until somebody stopped the run
};

}  // namespace semantic_kiss::live

#endif  // SEMANTIC_KISS_LIVE_SNAPSHOT_H_
