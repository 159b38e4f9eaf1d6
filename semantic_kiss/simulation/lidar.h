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
};

// An angle by its cosine and sine.
struct UnitAngle {
  double cosine = 1., sine = 0.;

  static UnitAngle Of(double angle_rad);
  // The sum with an angle far below 1, exact to its fifth power over 120.
  UnitAngle TurnedBy(double small_rad) const;
};

// sine * sin(azimuth) + cosine * cos(azimuth): what varies once a turn.
struct Harmonic {
  double cosine = 0., sine = 0.;

  // amplitude * sin(azimuth + phase)
  static Harmonic Of(double amplitude, double phase);
  double At(const UnitAngle& azimuth) const {
    return cosine * azimuth.cosine + sine * azimuth.sine;
  }
};

// What warming up and play change in a device, as it is during one scan [rad]; all beams share it.
struct Condition {
  double elevation = 0.;  // error of it
  Harmonic tilt;          // error of the elevation by direction
  Harmonic encoder;       // error of the azimuth
};

// One beam of a firing; directions are unit vectors in the sensor's frame.
struct Shot {
  Eigen::Vector3d believed;  // by the data sheet and the encoder
  Eigen::Vector3d actual;
  bool hidden;  // the car is in the way
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
  Lidar(const proto::LidarOptions& lidar, const proto::ErrorOptions& errors, double scan_rate_hz,
        uint64_t seed);

  int beams() const { return static_cast<int>(beams_.size()); }
  int columns() const { return options_.columns(); }
  const proto::LidarOptions& options() const { return options_; }

  // The sweep begins and ends behind the car; the beams turn to the left.
  double NominalAzimuth(int column) const;
  double NominalElevation(int beam) const { return beams_[beam].elevation; }
  // How the device is at a scan: near to how it is at the next one, and far from how it is a
  // minute later.
  Condition ConditionAt(int scan) const;
  // By how much a beam points elsewhere than the device believes, which sees it at `azimuth`.
  Bearing Error(int beam, const Condition& condition, const UnitAngle& azimuth) const;
  // All beams at once; the vector gets as many elements.
  void Fire(int column, const Condition& condition, std::vector<Shot>* shots) const;

  // Whether a return is strong enough to be noticed.
  bool Detects(const Return& echo, Random* random) const;
  double MeasureRange(int beam, const Return& echo, Random* random) const;

 private:
  struct Beam {
    double elevation = 0.;  // nominal
    UnitAngle nominal;      // the same
    double elevation_error = 0., azimuth_error = 0., range_error_m = 0.;
    Harmonic once, twice;  // of the elevation's error, over a turn
  };
  Beam DrawBeam(int bank, double elevation, Random* random) const;

  const proto::LidarOptions options_;
  const proto::ErrorOptions errors_;
  std::vector<Beam> beams_;
  Harmonic tilt_, encoder_;  // on average
  const uint64_t wander_key_;
  const double scans_per_wander_;
};

// The lidar that `options` drives with; the error lists the names there are.
absl::StatusOr<proto::LidarOptions> FindLidar(const proto::SimulationOptions& options);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_LIDAR_H_
