// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_ACTIVE_PLANAR_SUBMAPS_H_
#define CARTOGRAPHER_SUBMAP_ACTIVE_PLANAR_SUBMAPS_H_

#include <map>
#include <memory>

#include "cartographer/registration/labeled_voxel_map.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/probability_grid.h"
#include "cartographer/submap/proto/planar_submap_options.pb.h"
#include "cartographer/submap/submap.h"
#include "cartographer/submap/submap_succession.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::submap {

// The submaps that grow at the moment (submap_succession.h), with a grid of probabilities each,
// which a builder in the plane matches its scans with.
//
// When a submap is finished its probabilities become hits (ProbabilityGrid::EquivalentHits()) in
// the layer of the label that was seen the most in the cell. So the back end's occupancy score
// finds what ray casting left standing, files and pictures work as for other builders, and labels
// have decided nothing but the layer. Classes with the role `moving` are matched like any other,
// but left out of what is finished.
class ActivePlanarSubmaps {
 public:
  ActivePlanarSubmaps(const proto::PlanarSubmapOptions& options, const sensor::LabelSet& labels);

  // What the next scan is matched with: the grid that knows the most, and its pose. Null before
  // the first scan; valid until the next one.
  struct Reference {
    const ProbabilityGrid* grid = nullptr;
    transform::Rigid3d local_from_submap;
  };
  Reference reference() const;

  // Adds a scan, without ground and in the sensor's frame, to all active submaps, beginning and
  // finishing submaps as the options say. Returns those that took it, by their running number,
  // oldest first. `local_from_sensor` must be level.
  std::map<int, std::shared_ptr<const Submap>> AddScan(const sensor::LabeledPointCloud& scan,
                                                       const transform::Rigid3d& local_from_sensor);

  // Finishes whatever still grows.
  void FinishAll();

 private:
  struct Growing {
    std::shared_ptr<Submap> submap;
    ProbabilityGrid probabilities;
    registration::LabeledVoxelMap cloud;
  };

  void Begin(const transform::Rigid3d& local_from_sensor);
  void Grow(const sensor::LabeledPointCloud& scan, const transform::Rigid3d& local_from_sensor,
            Growing* growing) const;
  static void Finish(const Growing& growing);

  const proto::PlanarSubmapOptions options_;
  const sensor::LabelMask moving_;
  const sensor::LabelMask critical_;
  SubmapSuccession<Growing> succession_;
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_ACTIVE_PLANAR_SUBMAPS_H_
