// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/active_submaps.h"

#include <optional>
#include <utility>

#include "cartographer/common/parallel.h"

namespace cartographer::submap {
namespace {

void Finish(const registration::LabeledVoxelMap& cloud, Submap* submap) {
  submap->cloud = cloud.ToPointCloud();
  submap->finished = true;
}

}  // namespace

ActiveSubmaps::ActiveSubmaps(const proto::SubmapOptions& options, const sensor::LabelSet& labels)
    : options_(options),
      moving_(labels.WithRole(sensor::LabelRole::kMoving)),
      critical_(labels.WithRole(sensor::LabelRole::kCritical)),
      succession_(options.scans_per_submap()) {}

std::map<int, std::shared_ptr<const Submap>> ActiveSubmaps::AddScan(
    const sensor::LabeledPointCloud& dense, const sensor::LabeledPointCloud& sparse,
    const transform::Rigid3d& local_from_sensor) {
  if (succession_.NeedsNew()) Begin(local_from_sensor);
  const sensor::LabeledPointCloud static_sparse = sensor::WithoutLabels(sparse, moving_);
  auto& growing = succession_.growing();
  common::ParallelChunks(growing.size(), 1, [&](size_t i, size_t) {
    Grow(dense, static_sparse, local_from_sensor, &growing[i]);
  });
  const std::map<int, std::shared_ptr<const Submap>> submaps = succession_.Submaps();
  const std::optional<Growing> full = succession_.TakeFull();
  if (full.has_value()) Finish(full->cloud, full->submap.get());
  return submaps;
}

void ActiveSubmaps::FinishAll() {
  for (Growing& growing : succession_.growing()) Finish(growing.cloud, growing.submap.get());
  succession_.growing().clear();
}

void ActiveSubmaps::Begin(const transform::Rigid3d& local_from_sensor) {
  auto submap = std::make_shared<Submap>(options_.resolution_m());
  submap->local_from_submap = transform::Level(local_from_sensor);
  succession_.Begin(
      {std::move(submap), registration::LabeledVoxelMap(options_.cloud(), critical_)});
}

void ActiveSubmaps::Grow(const sensor::LabeledPointCloud& dense,
                         const sensor::LabeledPointCloud& sparse,
                         const transform::Rigid3d& local_from_sensor, Growing* growing) const {
  Submap& submap = *growing->submap;
  const transform::Rigid3d submap_from_sensor =
      submap.local_from_submap.inverse() * local_from_sensor;
  submap.grid.AddCloud(dense, submap_from_sensor, moving_);
  growing->cloud.Insert(sparse, submap_from_sensor);
  ++submap.num_scans;
}

}  // namespace cartographer::submap
