// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_MAP_CLOUD_H_
#define CARTOGRAPHER_IO_MAP_CLOUD_H_

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/io/map_point.h"
#include "cartographer/io/proto/render_options.pb.h"
#include "cartographer/io/voxel_thinning.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::io {

enum class CloudSource {
  kSubmaps,  // the submaps' sparse clouds
  kNodes     // the nodes' sub-sampled scans, which know intensities as well
};

// All points of a map file in the map frame, as they are written to point cloud files.
class MapCloud {
 public:
  // Reads the file once; only a few records and the points that come out are in memory. Leaves out
  // what `show` and `hide` of the options do; thins to cubes of `cloud_resolution_m`
  // (voxel_thinning.h). Errors: those of MapStream; unknown labels; nothing left to write.
  static absl::StatusOr<MapCloud> Read(const std::string& map_path, CloudSource source,
                                       const proto::RenderOptions& options);

  size_t size() const;
  MapPoint At(size_t index) const;
  // Whether every point had an intensity.
  bool has_intensities() const { return has_intensities_; }
  const sensor::LabelSet& labels() const { return labels_; }

 private:
  absl::Status Add(const sensor::LabeledPointCloud& cloud, const transform::Rigid3d& map_from_cloud,
                   const sensor::LabelMask& hidden);

  sensor::LabelSet labels_;
  bool has_intensities_ = true;
  std::variant<std::vector<MapPoint>, VoxelThinning> points_;  // as they are, or thinned
};

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_MAP_CLOUD_H_
