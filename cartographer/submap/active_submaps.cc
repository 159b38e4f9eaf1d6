// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/active_submaps.h"

#include "tbb/parallel_for_each.h"

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
      critical_(labels.WithRole(sensor::LabelRole::kCritical)) {}

std::map<int, std::shared_ptr<const Submap>> ActiveSubmaps::AddScan(
    const sensor::LabeledPointCloud& dense, const sensor::LabeledPointCloud& sparse,
    const transform::Rigid3d& local_from_sensor) {
  if (growing_.empty() || growing_.back().submap->num_scans >= options_.scans_per_submap() / 2) {
    Begin(local_from_sensor);
  }
  const sensor::LabeledPointCloud static_sparse = sensor::WithoutLabels(sparse, moving_);
  tbb::parallel_for_each(growing_.begin(), growing_.end(), [&](Growing& growing) {
    Grow(dense, static_sparse, local_from_sensor, &growing);
  });

  std::map<int, std::shared_ptr<const Submap>> submaps;
  for (const Growing& growing : growing_) submaps.emplace(growing.index, growing.submap);
  Growing& oldest = growing_.front();
  if (oldest.submap->num_scans >= options_.scans_per_submap()) {
    Finish(oldest.cloud, oldest.submap.get());
    growing_.pop_front();
  }
  return submaps;
}

void ActiveSubmaps::FinishAll() {
  for (Growing& growing : growing_) Finish(growing.cloud, growing.submap.get());
  growing_.clear();
}

void ActiveSubmaps::Begin(const transform::Rigid3d& local_from_sensor) {
  auto submap = std::make_shared<Submap>(options_.resolution_m());
  submap->local_from_submap = transform::Level(local_from_sensor);
  growing_.push_back({num_begun_++, std::move(submap),
                      registration::LabeledVoxelMap(options_.cloud(), critical_)});
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
