// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/options_loader.h"
#include "cartographer/common/parallel.h"
#include "cartographer/common/status.h"
#include "semantic_kiss/simulation/drive.h"
#include "semantic_kiss/simulation/label_noise.h"
#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/redrive.h"
#include "semantic_kiss/simulation/sequence_writer.h"

namespace semantic_kiss::simulation {
namespace {

// Scans between two calls of progress; a multiple of the usual numbers of cores.
constexpr int kBatch = 16;

// Tells recorded routes apart whose files have the same name.
uint64_t Fingerprint(const Route& route) {
  uint64_t hash = route.poses.size();
  for (const PlanarPose& pose : route.poses) {
    hash = HashKey({hash, static_cast<uint64_t>(std::llround(1e6 * pose.position.x())),
                    static_cast<uint64_t>(std::llround(1e6 * pose.position.y()))});
  }
  return hash;
}

std::string Manifest(const Simulation& simulation) {
  return absl::StrFormat("-- Made by semantic_kiss simulate; route %016x\n%s",
                         Fingerprint(simulation.route()),
                         cartographer::common::OptionsToLua(simulation.options()));
}

}  // namespace

absl::StatusOr<std::unique_ptr<Simulation>> Simulation::Create(
    const proto::SimulationOptions& options) {
  ASSIGN_OR_RETURN(const proto::LidarOptions lidar, FindLidar(options));
  ASSIGN_OR_RETURN(Route route, MakeRoute(options.route(), options.scan_rate_hz(),
                                          static_cast<uint64_t>(options.seed())));
  Route driven = Redrive(route, options.route().lane_offset_m(), options.route().speed_factor());
  if (route.poses.size() < 2 || driven.poses.size() < 2) {
    return absl::InvalidArgumentError(
        "the drive has fewer than two scans; make the route longer, the scan rate higher or the "
        "speed factor smaller");
  }
  return std::unique_ptr<Simulation>(
      new Simulation(options, std::move(route), std::move(driven), lidar));
}

Simulation::Simulation(const proto::SimulationOptions& options, Route planned, Route driven,
                       const proto::LidarOptions& lidar)
    : options_(options), planned_(std::move(planned)), driven_(std::move(driven)) {
  const auto seed = static_cast<uint64_t>(options_.seed());
  const double mount_m = lidar.mount_height_m();
  lidar_ = std::make_unique<Lidar>(lidar, options_.errors(), options_.scan_rate_hz(), seed);
  world_ = std::make_unique<World>(planned_, options_.world(), mount_m, seed, options_.epoch());
  world_from_start_ =
      DriveOverHills(planned_, world_->hills(), options_.route(), mount_m, seed).front();
  world_from_lidar_ = DriveOverHills(driven_, world_->hills(), options_.route(), mount_m, seed);
  traffic_ =
      std::make_unique<Traffic>(driven_, world_->streets(), options_.world().traffic_density(),
                                options_.scan_rate_hz(), seed, options_.epoch());
  scanner_ = std::make_unique<Scanner>(*world_, *traffic_, *lidar_, world_from_lidar_, options_);
}

SimulatedScan Simulation::Scan(int index) const {
  SimulatedScan points = scanner_->Sweep(index);
  if (options_.label_noise().share() > 0.) {
    AddLabelNoise(options_.label_noise(), static_cast<uint64_t>(options_.seed()), index, &points);
  }
  return points;
}

double Simulation::length_m() const {
  double length_m = 0.;
  for (size_t i = 1; i < driven_.poses.size(); ++i) {
    length_m += (driven_.poses[i].position - driven_.poses[i - 1].position).norm();
  }
  return length_m;
}

int ScansToWrite(const Simulation& simulation, const WriteRequest& request) {
  if (request.num_scans <= 0) return simulation.num_scans();
  return std::min(request.num_scans, simulation.num_scans());
}

absl::Status WriteSequence(const Simulation& simulation, const WriteRequest& request,
                           const WriteProgress& progress) {
  const int total = ScansToWrite(simulation, request);
  const ScanColumns columns{simulation.options().label_noise().share() > 0.,
                            simulation.options().raw()};
  ASSIGN_OR_RETURN(
      const SequenceWriter writer,
      SequenceWriter::Open(request.directory, request.sequence, columns, Manifest(simulation)));
  for (int first = 0; first < total; first += kBatch) {
    const int size = std::min(kBatch, total - first);
    std::vector<absl::Status> statuses(size);
    cartographer::common::ParallelChunks(size, 1, [&](size_t i, size_t) {
      const int scan = first + static_cast<int>(i);
      if (!writer.IsComplete(scan)) {
        statuses[i] = writer.WriteScan(scan, simulation.Scan(scan));
      }
    });
    for (const absl::Status& status : statuses) RETURN_IF_ERROR(status);
    if (!progress(first + size)) {
      return absl::CancelledError(absl::StrCat("after ", first + size, " of ", total,
                                               " scans; the same command goes on from there"));
    }
  }
  // Scans that an earlier, longer command left belong to the drive as well.
  int present = total;
  while (present < simulation.num_scans() && writer.IsComplete(present)) ++present;
  std::vector<cartographer::transform::Rigid3d> start_from_lidar;
  for (int i = 0; i < present; ++i) {
    start_from_lidar.push_back(simulation.world_from_start().inverse() *
                               simulation.world_from_lidar()[i]);
  }
  return writer.WriteDrive(start_from_lidar, simulation.options().scan_rate_hz());
}

}  // namespace semantic_kiss::simulation
