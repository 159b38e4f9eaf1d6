// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SIMULATION_H_
#define SEMANTIC_KISS_SIMULATION_SIMULATION_H_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/simulation/lidar.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/route.h"
#include "semantic_kiss/simulation/scanner.h"
#include "semantic_kiss/simulation/traffic.h"
#include "semantic_kiss/simulation/world.h"

namespace semantic_kiss::simulation {

// A drive through a simulated town, ready to be scanned: a function of its options alone.
class Simulation {
 public:
  // Plans the route and builds the town (seconds for a few kilometres). Errors: the poses file
  // cannot be used; no lidar of that name.
  static absl::StatusOr<std::unique_ptr<Simulation>> Create(
      const proto::SimulationOptions& options);

  double length_m() const;
  int num_scans() const { return static_cast<int>(world_from_lidar_.size()); }

  // The scan as it is written, labels and certainties included. Any thread may ask for any scan.
  SimulatedScan Scan(int index) const;

  const proto::SimulationOptions& options() const { return options_; }
  const Route& route() const { return driven_; }
  const World& world() const { return *world_; }
  const Lidar& lidar() const { return *lidar_; }
  // The lidar's pose at the end of the first sweep of the drive that the town was planned for: the
  // frame of all poses that are written, whoever drives there and when.
  const cartographer::transform::Rigid3d& world_from_start() const { return world_from_start_; }
  // True poses at the end of every sweep.
  const std::vector<cartographer::transform::Rigid3d>& world_from_lidar() const {
    return world_from_lidar_;
  }

 private:
  Simulation(const proto::SimulationOptions& options, Route planned, Route driven,
             const proto::LidarOptions& lidar);

  const proto::SimulationOptions options_;
  const Route planned_;  // what the town is built along
  const Route driven_;
  std::unique_ptr<Lidar> lidar_;
  std::unique_ptr<World> world_;
  cartographer::transform::Rigid3d world_from_start_;
  std::vector<cartographer::transform::Rigid3d> world_from_lidar_;
  std::unique_ptr<Traffic> traffic_;
  std::unique_ptr<Scanner> scanner_;
};

struct WriteRequest {
  std::string directory;
  std::string sequence = "00";
  int num_scans = 0;  // 0: the whole drive
};

// Number of scans that the request asks for.
int ScansToWrite(const Simulation& simulation, const WriteRequest& request);

// Told after every few scans: how many of the wanted ones are there. Returns false to stop.
using WriteProgress = std::function<bool(int done)>;

// Writes the drive as a SemanticKITTI sequence, scans in parallel on the calling arena's threads.
// Scans that are already there are kept, so an interrupted run may be repeated. Cancelled: progress
// asked to stop; all files are whole.
absl::Status WriteSequence(const Simulation& simulation, const WriteRequest& request,
                           const WriteProgress& progress);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SIMULATION_H_
