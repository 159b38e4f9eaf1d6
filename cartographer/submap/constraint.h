// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SUBMAP_CONSTRAINT_H_
#define CARTOGRAPHER_SUBMAP_CONSTRAINT_H_

#include <Eigen/Core>
#include <optional>

#include "cartographer/submap/id.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::submap {

// What is known of a node relative to a submap.
struct Constraint {
  enum class Kind {
    kIntraSubmap,  // the node's scan is in the submap
    kInterSubmap   // found by loop closure
  };
  SubmapId submap_id;
  NodeId node_id;
  transform::Rigid3d submap_from_node;
  // How well, as inverse standard deviations [1/m, 1/rad], of which only ratios count. These are
  // what Cartographer gives by default to scans within a submap: with them it can optimize our
  // maps.
  double translation_weight = 5e2;
  double rotation_weight = 1.6e3;
  Kind kind = Kind::kIntraSubmap;
  // The weights in full, where they are known: the inverse covariance of Log(submap_from_node^-1 *
  // truth), ordered as transform::Twist. It then overrides the weights.
  std::optional<Eigen::Matrix<double, 6, 6>> information = std::nullopt;
};

}  // namespace cartographer::submap

#endif  // CARTOGRAPHER_SUBMAP_CONSTRAINT_H_
