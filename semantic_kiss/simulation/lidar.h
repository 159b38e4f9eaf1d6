// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_LIDAR_H_
#define SEMANTIC_KISS_SIMULATION_LIDAR_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"
#include "semantic_kiss/simulation/random.h"

namespace semantic_kiss::simulation {

// Where a beam points: elevation above the sensor's x-y plane, azimuth from x towards y [rad].
struct Bearing {
  double elevation = 0., azimuth = 0.;
  Eigen::Vector3d Direction() const;
};

// What a return is like, for its range error and its chance to be seen.
struct Return {
  double range_m;
  double remission;  // of the surface
  double facing;     // cosine of the angle of incidence, in (0, 1]
};

// One device: where its beams really point and how it measures, as against what its data sheet
// says. Errors are drawn from the seed; two seeds are two devices of one make.
class Lidar {
 public:
  Lidar(const proto::LidarOptions& lidar, const proto::ErrorOptions& errors, uint64_t seed);

  int beams() const { return static_cast<int>(beams_.size()); }
  int columns() const { return options_.columns(); }
  const proto::LidarOptions& options() const { return options_; }

  // The sweep begins and ends behind the car; the beams turn to the left.
  double NominalAzimuth(int column) const;
  Bearing Nominal(int beam, int column) const;
  // Where the beam points in truth when the device believes it points at `nominal`.
  Bearing True(int beam, const Bearing& nominal) const;

  // Whether the car's roof is in the beam's way.
  bool Hidden(const Bearing& nominal) const;

  // Whether a return is strong enough to be noticed.
  bool Detects(const Return& echo, Random* random) const;
  double MeasureRange(int beam, const Return& echo, Random* random) const;

 private:
  struct Beam {
    double elevation = 0.;  // nominal
    double elevation_error = 0., azimuth_error = 0., range_error_m = 0.;
    double first_amplitude = 0., first_phase = 0., second_amplitude = 0., second_phase = 0.;
  };
  void DrawErrors(int bank, Random* random, Beam* beam) const;

  const proto::LidarOptions options_;
  const proto::ErrorOptions errors_;
  std::vector<Beam> beams_;
  double tilt_phase_, encoder_phase_;
};

// The lidar that `options` drives with; the error lists the names there are.
absl::StatusOr<proto::LidarOptions> FindLidar(const proto::SimulationOptions& options);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_LIDAR_H_
