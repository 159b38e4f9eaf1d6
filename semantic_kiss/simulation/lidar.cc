// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/lidar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kRadPerDeg = M_PI / 180.;
constexpr double kGrey = 0.3;             // remission that option values refer to
constexpr double kSteepestTangent = 10.;  // of the incidence, for the footprint

// Lowest elevation [deg] that passes over the roof of a car like KITTI's, every 10 degrees from
// straight behind turning to the left (so index 18 is straight ahead).
constexpr std::array<double, 36> kRoof_deg = {
    -17.2, -17.2, -17.,  -22.,  -21.5, -20.5, -30., -30.,  -30.,  -30.,  -30.,  -15.5,
    -30.,  -30.,  -22.8, -22.5, -21.8, -21.,  -21., -21.8, -23.,  -22.3, -30.,  -30.,
    -30.,  -30.,  -30.,  -30.,  -30.,  -30.,  -30., -19.8, -22.6, -22.,  -17.5, -17.};

}  // namespace

Eigen::Vector3d Bearing::Direction() const {
  const double level = std::cos(elevation);
  return Eigen::Vector3d(level * std::cos(azimuth), level * std::sin(azimuth), std::sin(elevation));
}

Lidar::Lidar(const proto::LidarOptions& lidar, const proto::ErrorOptions& errors, uint64_t seed)
    : options_(lidar), errors_(errors) {
  Random random(seed, Purpose::kBeam);
  tilt_phase_ = random.Uniform(0., 2. * M_PI);
  encoder_phase_ = random.Uniform(0., 2. * M_PI);
  for (int bank = 0; bank < lidar.banks_size(); ++bank) {
    const proto::BeamBank& bank_options = lidar.banks(bank);
    const double spread = bank_options.last_elevation_deg() - bank_options.first_elevation_deg();
    for (int i = 0; i < bank_options.beams(); ++i) {
      const double fraction = bank_options.beams() > 1 ? i / (bank_options.beams() - 1.) : 0.;
      Beam beam;
      beam.elevation = kRadPerDeg * (bank_options.first_elevation_deg() + fraction * spread);
      DrawErrors(bank, &random, &beam);
      beams_.push_back(beam);
    }
  }
}

void Lidar::DrawErrors(int bank, Random* random, Beam* beam) const {
  const double side = bank % 2 == 0 ? 0.5 : -0.5;
  const double directional = kRadPerDeg * errors_.directional_elevation_deg();
  beam->elevation_error = kRadPerDeg * (errors_.beam_elevation_deg() * random->Normal() +
                                        side * errors_.bank_elevation_deg());
  beam->azimuth_error = kRadPerDeg * errors_.beam_azimuth_deg() * random->Normal();
  beam->range_error_m = errors_.beam_range_m() * random->Normal() + side * errors_.bank_range_m();
  beam->first_amplitude = directional * random->Normal();
  beam->first_phase = random->Uniform(0., 2. * M_PI);
  beam->second_amplitude = directional * random->Normal();
  beam->second_phase = random->Uniform(0., 2. * M_PI);
}

double Lidar::NominalAzimuth(int column) const {
  return -M_PI + 2. * M_PI * (column + 0.5) / columns();
}

Bearing Lidar::Nominal(int beam, int column) const {
  return {beams_[beam].elevation, NominalAzimuth(column)};
}

Bearing Lidar::True(int index, const Bearing& nominal) const {
  const Beam& beam = beams_[index];
  const double azimuth = nominal.azimuth;
  Bearing bearing = nominal;
  bearing.elevation += beam.elevation_error +
                       beam.first_amplitude * std::sin(azimuth + beam.first_phase) +
                       beam.second_amplitude * std::sin(2. * azimuth + beam.second_phase) +
                       kRadPerDeg * errors_.axis_tilt_deg() * std::sin(azimuth + tilt_phase_);
  bearing.azimuth += beam.azimuth_error + kRadPerDeg * errors_.encoder_eccentricity_deg() *
                                              std::sin(azimuth + encoder_phase_);
  return bearing;
}

bool Lidar::Hidden(const Bearing& nominal) const {
  if (!options_.hidden_by_car()) return false;
  const double turn = (nominal.azimuth + M_PI) / (2. * M_PI);
  const int sector =
      static_cast<int>(std::floor(turn * kRoof_deg.size())) % static_cast<int>(kRoof_deg.size());
  return nominal.elevation < kRadPerDeg * kRoof_deg[sector];
}

bool Lidar::Detects(const Return& echo, Random* random) const {
  const double strength = echo.remission / kGrey * std::sqrt(echo.facing);
  const double reach = echo.range_m / options_.half_return_range_m();
  const double weakness = reach * reach / std::max(1e-3, strength);
  const double seen = std::exp(-M_LN2 * weakness * weakness);
  return random->Chance(seen * (1. - errors_.dropout()));
}

double Lidar::MeasureRange(int beam, const Return& echo, Random* random) const {
  const double tangent =
      std::min(kSteepestTangent, std::sqrt(1. - echo.facing * echo.facing) / echo.facing);
  const double stretch_m = kRadPerDeg * errors_.divergence_deg() * echo.range_m * tangent;
  const double noise_m = std::hypot(errors_.range_noise_m(), 0.1 * stretch_m) * random->Normal();
  return echo.range_m * (1. + errors_.range_scale()) + beams_[beam].range_error_m +
         errors_.intensity_range_m() * (kGrey - echo.remission) +
         errors_.incidence_bias() * stretch_m + noise_m;
}

absl::StatusOr<proto::LidarOptions> FindLidar(const proto::SimulationOptions& options) {
  std::string names;
  for (const proto::LidarOptions& lidar : options.lidars()) {
    if (lidar.name() == options.lidar()) return lidar;
    absl::StrAppend(&names, names.empty() ? "" : ", ", lidar.name());
  }
  return absl::InvalidArgumentError(
      absl::StrCat("lidar \"", options.lidar(), "\" is not declared; there are: ", names));
}

}  // namespace semantic_kiss::simulation
