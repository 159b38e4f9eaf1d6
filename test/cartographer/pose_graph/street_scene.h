// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_POSE_GRAPH_STREET_SCENE_H_
#define TEST_CARTOGRAPHER_POSE_GRAPH_STREET_SCENE_H_

#include <string>
#include <vector>

#include "cartographer/pose_graph/closure_target.h"
#include "cartographer/pose_graph/proto/verification_options.pb.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::pose_graph {

// Labels are those of test/cartographer/scan_matching/small_scenes.h.
struct ScenePoint {
  Eigen::Vector3d position;  // [m], frame of the scene: level, its ground near z = 0
  int label;
};

// A made-up street along x, 100 m long: road and sidewalks that rise by 2 %, houses of different
// lengths on both sides that stand back by different amounts, poles, parked cars.
struct StreetOptions {
  int seed = 1;           // of what is built: another seed is another street
  int parked_cars = 1;    // seed of where cars stand; 0: none
  bool landmarks = true;  // false: endless straight walls, nothing else
};
std::vector<ScenePoint> MakeStreet(const StreetOptions& options);

// What one visit sees: a share of the points, moved by noise of a few centimetres, within 45 m of
// the pose. `visit` is the seed of share and noise. In the frame of the pose.
struct VisitOptions {
  int visit = 1;
  double share = 0.1;
  double label_noise = 0.;  // share of points with a random label of low certainty
};
sensor::LabeledPointCloud SeeFrom(const std::vector<ScenePoint>& street,
                                  const transform::Rigid3d& scene_from_sensor,
                                  const VisitOptions& options);

// The options as shipped, with Lua that may change CLOSURE_VERIFICATION.
proto::VerificationOptions ShippedVerificationOptions(const std::string& overrides = "");

// Of a dense visit from the scene's origin; the target's frame is the scene's.
ClosureTarget TargetOf(const std::vector<ScenePoint>& street,
                       const proto::VerificationOptions& options);

// A node on the street: 1.7 m above its ground, a little rolled and pitched.
transform::Rigid3d NodeOnStreet(double x, double y, double yaw_rad);

}  // namespace cartographer::pose_graph

#endif  // TEST_CARTOGRAPHER_POSE_GRAPH_STREET_SCENE_H_
