// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SCANNER_H_
#define SEMANTIC_KISS_SIMULATION_SCANNER_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "cartographer/transform/rigid_transform.h"
#include "cartographer/transform/se3.h"
#include "semantic_kiss/simulation/lidar.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/ray_fan.h"
#include "semantic_kiss/simulation/traffic.h"
#include "semantic_kiss/simulation/world.h"

namespace semantic_kiss::simulation {

// A return as the device reports it, and what it really is.
struct SimulatedPoint {
  Eigen::Vector3f position;  // as written [m], sensor frame
  float remission;           // in [0, 1], in steps of 0.01
  float time_s = 0.f;        // relative to the end of the sweep, in [-1/rate, 0]
  uint16_t label;            // SemanticKITTI id
  float certainty = 1.f;     // P(label | ...)
  uint32_t object;           // number of the thing hit
  int primitive;             // index in the world, -1: ground; meaningless if moving
  bool moving;
  Eigen::Vector3f true_position;  // where the surface was hit [m], world frame
  int32_t beam, column;
};

// Beam by beam from the top, each from the start of the sweep: the order of KITTI's files.
using SimulatedScan = std::vector<SimulatedPoint>;

// Sweeps the lidar over the world along the drive.
class Scanner {
 public:
  // All references must outlive the scanner. `noise_seed` feeds the chances of every ray.
  Scanner(const World& world, const Traffic& traffic, const Lidar& lidar,
          const std::vector<cartographer::transform::Rigid3d>& world_from_lidar,
          const proto::SimulationOptions& options);

  // The sweep that ends at pose `scan`. A function of the arguments alone: any thread may ask for
  // any scan.
  SimulatedScan Sweep(int scan) const;

 private:
  struct SweepState;
  struct Column;
  SweepState BeginSweep(int scan) const;
  void BeginColumn(const SweepState& sweep, int index, Column* column, RayFan* fan) const;
  // The return of one beam, if there is one.
  std::optional<SimulatedPoint> Fire(const Column& column, const RayFan& fan, int beam,
                                     uint64_t key) const;
  Eigen::Vector3f Written(const Column& column, const Eigen::Vector3d& measured) const;

  const World& world_;
  const Traffic& traffic_;
  const Lidar& lidar_;
  const std::vector<cartographer::transform::Rigid3d>& world_from_lidar_;
  const proto::SimulationOptions& options_;
  const UnitAngle vertical_error_;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SCANNER_H_
