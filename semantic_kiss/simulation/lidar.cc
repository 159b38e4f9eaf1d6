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

double RoofAt_deg(double azimuth) {
  const double turn = (azimuth + M_PI) / (2. * M_PI);
  return kRoof_deg[static_cast<size_t>(turn * kRoof_deg.size()) % kRoof_deg.size()];
}

Eigen::Vector3d Direction(const UnitAngle& elevation, const UnitAngle& azimuth) {
  return {elevation.cosine * azimuth.cosine, elevation.cosine * azimuth.sine, elevation.sine};
}

}  // namespace

UnitAngle UnitAngle::Of(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

UnitAngle UnitAngle::TurnedBy(double small_rad) const {
  const double square = small_rad * small_rad;
  const double c = 1. - 0.5 * square * (1. - square / 12.);
  const double s = small_rad * (1. - square / 6.);
  return {cosine * c - sine * s, sine * c + cosine * s};
}

Harmonic Harmonic::Of(double amplitude, double phase) {
  return {amplitude * std::sin(phase), amplitude * std::cos(phase)};
}

Lidar::Lidar(const proto::LidarOptions& lidar, const proto::ErrorOptions& errors,
             double scan_rate_hz, uint64_t seed)
    : options_(lidar),
      errors_(errors),
      wander_key_(HashKey({seed, static_cast<uint64_t>(Purpose::kWander)})),
      scans_per_wander_(scan_rate_hz * errors.wander_s()) {
  Random random(seed, Purpose::kBeam);
  tilt_ = Harmonic::Of(kRadPerDeg * errors.axis_tilt_deg(), random.Uniform(0., 2. * M_PI));
  encoder_ =
      Harmonic::Of(kRadPerDeg * errors.encoder_eccentricity_deg(), random.Uniform(0., 2. * M_PI));
  for (int bank = 0; bank < lidar.banks_size(); ++bank) {
    const proto::BeamBank& bank_options = lidar.banks(bank);
    const double spread = bank_options.last_elevation_deg() - bank_options.first_elevation_deg();
    for (int i = 0; i < bank_options.beams(); ++i) {
      const double fraction = bank_options.beams() > 1 ? i / (bank_options.beams() - 1.) : 0.;
      beams_.push_back(DrawBeam(
          bank, kRadPerDeg * (bank_options.first_elevation_deg() + fraction * spread), &random));
    }
  }
}

Lidar::Beam Lidar::DrawBeam(int bank, double elevation, Random* random) const {
  Beam beam;
  beam.elevation = elevation;
  beam.nominal = UnitAngle::Of(elevation);
  const double side = bank % 2 == 0 ? 0.5 : -0.5;
  const double directional = kRadPerDeg * errors_.directional_elevation_deg();
  beam.elevation_error = kRadPerDeg * (errors_.beam_elevation_deg() * random->Normal() +
                                       side * errors_.bank_elevation_deg());
  beam.azimuth_error = kRadPerDeg * errors_.beam_azimuth_deg() * random->Normal();
  beam.range_error_m = errors_.beam_range_m() * random->Normal() + side * errors_.bank_range_m();
  const double first = directional * random->Normal();
  beam.once = Harmonic::Of(first, random->Uniform(0., 2. * M_PI));
  const double second = directional * random->Normal();
  beam.twice = Harmonic::Of(second, random->Uniform(0., 2. * M_PI));
  return beam;
}

double Lidar::NominalAzimuth(int column) const {
  return -M_PI + 2. * M_PI * (column + 0.5) / columns();
}

Condition Lidar::ConditionAt(int scan) const {
  const double time = scan / scans_per_wander_;
  const auto wander = [&](uint64_t n, double deviation_deg) {
    return kRadPerDeg * deviation_deg * Roughness(wander_key_ + 10 * n, time, 0.);
  };
  Condition condition;
  condition.elevation = wander(0, errors_.elevation_wander_deg());
  condition.tilt = {tilt_.cosine + wander(1, errors_.tilt_wander_deg()),
                    tilt_.sine + wander(2, errors_.tilt_wander_deg())};
  condition.encoder = {encoder_.cosine + wander(3, errors_.encoder_wander_deg()),
                       encoder_.sine + wander(4, errors_.encoder_wander_deg())};
  return condition;
}

Bearing Lidar::Error(int index, const Condition& condition, const UnitAngle& azimuth) const {
  const Beam& beam = beams_[index];
  const UnitAngle doubled{azimuth.cosine * azimuth.cosine - azimuth.sine * azimuth.sine,
                          2. * azimuth.cosine * azimuth.sine};
  return {beam.elevation_error + beam.once.At(azimuth) + beam.twice.At(doubled) +
              condition.elevation + condition.tilt.At(azimuth),
          beam.azimuth_error + condition.encoder.At(azimuth)};
}

void Lidar::Fire(int column, const Condition& condition, std::vector<Shot>* shots) const {
  const double azimuth = NominalAzimuth(column);
  const UnitAngle believed = UnitAngle::Of(azimuth);
  const double lowest = options_.hidden_by_car() ? kRadPerDeg * RoofAt_deg(azimuth) : -M_PI;
  shots->clear();
  for (int i = 0; i < beams(); ++i) {
    const Beam& beam = beams_[i];
    const Bearing error = Error(i, condition, believed);
    shots->push_back(
        {Direction(beam.nominal, believed),
         Direction(beam.nominal.TurnedBy(error.elevation), believed.TurnedBy(error.azimuth)),
         beam.elevation < lowest});
  }
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
  const double spread_m = 0.1 * stretch_m;
  const double noise_m =
      std::sqrt(errors_.range_noise_m() * errors_.range_noise_m() + spread_m * spread_m) *
      random->QuickNormal();
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
