// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_ACTIVE_SUBMAPS_H_
#define CARTOGRAPHER_SUBMAP_ACTIVE_SUBMAPS_H_

#include <map>
#include <memory>

#include "cartographer/registration/labeled_voxel_map.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/proto/submap_options.pb.h"
#include "cartographer/submap/submap.h"
#include "cartographer/submap/submap_succession.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::submap {

// The submaps that grow at the moment, at most two (submap_succession.h). Classes with the role
// `moving` are left out of all of them.
class ActiveSubmaps {
 public:
  ActiveSubmaps(const proto::SubmapOptions& options, const sensor::LabelSet& labels);

  // Adds a scan to all active submaps, beginning and finishing submaps as the options say. Returns
  // the submaps that took it, by their running number, oldest first.
  //   dense    all points, for the grids; sensor frame
  //   sparse   a sub-sampling of them, for the clouds; sensor frame
  std::map<int, std::shared_ptr<const Submap>> AddScan(const sensor::LabeledPointCloud& dense,
                                                       const sensor::LabeledPointCloud& sparse,
                                                       const transform::Rigid3d& local_from_sensor);

  // Finishes whatever still grows.
  void FinishAll();

 private:
  struct Growing {
    std::shared_ptr<Submap> submap;
    registration::LabeledVoxelMap cloud;
  };

  void Begin(const transform::Rigid3d& local_from_sensor);
  void Grow(const sensor::LabeledPointCloud& dense, const sensor::LabeledPointCloud& sparse,
            const transform::Rigid3d& local_from_sensor, Growing* growing) const;

  const proto::SubmapOptions options_;
  const sensor::LabelMask moving_;
  const sensor::LabelMask critical_;
  SubmapSuccession<Growing> succession_;
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_ACTIVE_SUBMAPS_H_
