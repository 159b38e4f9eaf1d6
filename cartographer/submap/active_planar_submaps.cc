// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/active_planar_submaps.h"

#include <optional>
#include <utility>
#include <vector>

#include "cartographer/common/parallel.h"

namespace cartographer::submap {
namespace {

constexpr int kTileSize = SemanticGrid::kTileSize;

// The hits that are left of `seen` once rays have been cast.
SemanticGrid OccupiedLayers(const SemanticGrid& seen, const ProbabilityGrid& probabilities) {
  SemanticGrid layers(seen.resolution_m());
  for (const auto& [index, tile] : seen.DominantTiles()) {
    for (int i = 0; i < kTileSize * kTileSize; ++i) {
      if (tile.hits[i] == 0) continue;
      const CellIndex cell(index.x * kTileSize + i % kTileSize,
                           index.y * kTileSize + i / kTileSize);
      const int hits = probabilities.EquivalentHits(cell);
      if (hits > 0) layers.AddHits(tile.labels[i], cell, hits);
    }
  }
  return layers;
}

}  // namespace

ActivePlanarSubmaps::ActivePlanarSubmaps(const proto::PlanarSubmapOptions& options,
                                         const sensor::LabelSet& labels)
    : options_(options),
      moving_(labels.WithRole(sensor::LabelRole::kMoving)),
      critical_(labels.WithRole(sensor::LabelRole::kCritical)),
      succession_(options.scans_per_submap()) {}

ActivePlanarSubmaps::Reference ActivePlanarSubmaps::reference() const {
  if (succession_.growing().empty()) return {};
  const Growing& oldest = succession_.growing().front();
  return {&oldest.probabilities, oldest.submap->local_from_submap};
}

std::map<int, std::shared_ptr<const Submap>> ActivePlanarSubmaps::AddScan(
    const sensor::LabeledPointCloud& scan, const transform::Rigid3d& local_from_sensor) {
  if (succession_.NeedsNew()) Begin(local_from_sensor);
  auto& growing = succession_.growing();
  common::ParallelChunks(growing.size(), 1,
                         [&](size_t i, size_t) { Grow(scan, local_from_sensor, &growing[i]); });
  const std::map<int, std::shared_ptr<const Submap>> submaps = succession_.Submaps();
  const std::optional<Growing> full = succession_.TakeFull();
  if (full.has_value()) Finish(*full);
  return submaps;
}

void ActivePlanarSubmaps::FinishAll() {
  for (const Growing& growing : succession_.growing()) Finish(growing);
  succession_.growing().clear();
}

void ActivePlanarSubmaps::Begin(const transform::Rigid3d& local_from_sensor) {
  auto submap = std::make_shared<Submap>(options_.grid().resolution_m());
  submap->local_from_submap = local_from_sensor;
  succession_.Begin({std::move(submap), ProbabilityGrid(options_.grid()),
                     registration::LabeledVoxelMap(options_.cloud(), critical_)});
}

void ActivePlanarSubmaps::Grow(const sensor::LabeledPointCloud& scan,
                               const transform::Rigid3d& local_from_sensor,
                               Growing* growing) const {
  Submap& submap = *growing->submap;
  const transform::Rigid3d submap_from_sensor =
      submap.local_from_submap.inverse() * local_from_sensor;
  std::vector<Eigen::Vector2d> points;
  points.reserve(scan.size());
  for (const Eigen::Vector3f& position : scan.positions) {
    points.emplace_back((submap_from_sensor * position.cast<double>()).head<2>());
  }
  growing->probabilities.InsertScan(submap_from_sensor.translation().head<2>(), points);
  submap.grid.AddCloud(scan, submap_from_sensor, moving_);
  growing->cloud.Insert(sensor::WithoutLabels(scan, moving_), submap_from_sensor);
  ++submap.num_scans;
}

void ActivePlanarSubmaps::Finish(const Growing& growing) {
  Submap& submap = *growing.submap;
  submap.grid = OccupiedLayers(submap.grid, growing.probabilities);
  submap.cloud = growing.cloud.ToPointCloud();
  submap.finished = true;
}

}  // namespace cartographer::submap
