// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_IO_MAP_SKETCH_H_
#define TEST_CARTOGRAPHER_IO_MAP_SKETCH_H_

#include <memory>
#include <string>
#include <vector>

#include "cartographer/io/semantic_raster.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// Grids and rasters as text. A row of characters is a row of cells, the topmost (largest y) first:
//   R road, S sidewalk (ground)   B building   C car (movable)   P pole (critical)   U unlabeled
//   '.' nothing
// Colours of the labels, by name: see map_sketch.cc.
using Sketch = std::vector<std::string>;

sensor::LabelSet SketchLabels();
// CHECK-fails for a name that is not among them.
sensor::Label SketchLabel(const std::string& name);

// The lower left character becomes cell (0, 0); every character is `hits` hits.
std::shared_ptr<submap::Submap> SubmapFromSketch(const Sketch& sketch, double resolution_m,
                                                 int hits = 1);

// A map with one trajectory, to which submaps and nodes are added by hand.
map::Map EmptyMap();
void AddSubmap(std::shared_ptr<const submap::Submap> submap, const transform::Rigid3d& pose,
               map::Map* map);
void AddNode(const Eigen::Vector3d& position, map::Map* map);

// A map of one submap at the origin.
map::Map MapFromSketch(const Sketch& sketch, double resolution_m, int hits = 1);

// A pose in the plane.
transform::Rigid3d PlanarPose(double x, double y, double yaw_rad);

// A raster with 1 hit where the sketch has a character, pixels of 1 m, lower left corner at 0, 0.
SemanticRaster RasterFromSketch(const Sketch& sketch);
// Filled pixels (a label, but 0 hits) are lower case.
Sketch SketchOf(const SemanticRaster& raster);

// The frame that FrameOf() gives without cropping; CHECK-fails where that is an error.
RasterFrame WholeFrame(const map::Map& map, double resolution_m);

}  // namespace cartographer::io

#endif  // TEST_CARTOGRAPHER_IO_MAP_SKETCH_H_
