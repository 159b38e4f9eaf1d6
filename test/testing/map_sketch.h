// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_TESTING_MAP_SKETCH_H_
#define TEST_TESTING_MAP_SKETCH_H_

#include <memory>
#include <string>
#include <vector>

#include "cartographer/io/semantic_raster.h"
#include "cartographer/map/map.h"

namespace semantic_kiss_testing {

// Grids and rasters as text. A row of characters is a row of cells, the topmost (largest y) first:
//   R road, S sidewalk (ground)   B building   C car (movable)   P pole (critical)   U unlabeled
//   '.' nothing
// Colours of the labels, by name: see map_sketch.cc.
using Sketch = std::vector<std::string>;

cartographer::sensor::LabelSet SketchLabels();
// CHECK-fails for a name that is not among them.
cartographer::sensor::Label SketchLabel(const std::string& name);

// The lower left character becomes cell (0, 0); every character is `hits` hits.
std::shared_ptr<cartographer::submap::Submap> SubmapFromSketch(const Sketch& sketch,
                                                               double resolution_m, int hits = 1);

// A map with one trajectory, to which submaps and nodes are added by hand.
cartographer::map::Map EmptyMap();
void AddSubmap(std::shared_ptr<const cartographer::submap::Submap> submap,
               const cartographer::transform::Rigid3d& pose, cartographer::map::Map* map);
void AddNode(const Eigen::Vector3d& position, cartographer::map::Map* map);

// A map of one submap at the origin.
cartographer::map::Map MapFromSketch(const Sketch& sketch, double resolution_m, int hits = 1);

// A pose in the plane.
cartographer::transform::Rigid3d PlanarPose(double x, double y, double yaw_rad);

// A raster with 1 hit where the sketch has a character, pixels of 1 m, lower left corner at 0, 0.
cartographer::io::SemanticRaster RasterFromSketch(const Sketch& sketch);
// Filled pixels (a label, but 0 hits) are lower case.
Sketch SketchOf(const cartographer::io::SemanticRaster& raster);

// The frame that FrameOf() gives without cropping; CHECK-fails where that is an error.
cartographer::io::RasterFrame WholeFrame(const cartographer::map::Map& map, double resolution_m);

}  // namespace semantic_kiss_testing

#endif  // TEST_TESTING_MAP_SKETCH_H_
