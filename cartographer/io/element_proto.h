// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_ELEMENT_PROTO_H_
#define CARTOGRAPHER_IO_ELEMENT_PROTO_H_

#include <memory>

#include "absl/status/statusor.h"
#include "cartographer/common/time.h"
#include "cartographer/mapping/proto/serialization.pb.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/submap.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::io {

// The elements of a map as records hold them: all but their poses in the map, which stand in the
// pose graph. Both carry what stock Cartographer reads and what only our maps know.

struct SubmapElement {
  submap::SubmapId id;
  std::shared_ptr<const submap::Submap> submap;
};

struct NodeElement {
  submap::NodeId id;
  common::Time time;
  transform::Rigid3d local_from_node;
  std::shared_ptr<const sensor::LabeledPointCloud> cloud;
};

// Errors name the element and what of it cannot be stored (cloud_proto.h, semantic_grid_proto.h,
// stock_grid.h).
absl::StatusOr<mapping::proto::Submap> ToProto(const SubmapElement& element,
                                               const sensor::LabelSet& labels);
absl::StatusOr<mapping::proto::Node> ToProto(const NodeElement& element,
                                             const sensor::LabelSet& labels);

// Which parts of a map are read. The others are left empty, unchecked, and cost little.
struct MapParts {
  bool grids = true;  // of submaps
  bool submap_clouds = true;
  bool node_clouds = true;
};

// Errors name the element. Elements of Cartographer's own maps come without labels: a submap's
// grid by FromStockGrid(), its cloud empty. kUnimplemented for submaps that are not 2D grids of
// probabilities.
absl::StatusOr<SubmapElement> FromProto(const mapping::proto::Submap& proto,
                                        const sensor::LabelSet& labels, const MapParts& parts);
absl::StatusOr<NodeElement> FromProto(const mapping::proto::Node& proto,
                                      const sensor::LabelSet& labels);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_ELEMENT_PROTO_H_
