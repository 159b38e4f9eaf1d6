// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_DRAW_TRAJECTORY_H_
#define CARTOGRAPHER_IO_DRAW_TRAJECTORY_H_

#include "cartographer/io/draw_canvas.h"
#include "cartographer/io/raster_frame.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

inline constexpr sensor::Color kTrajectoryColor{24, 30, 58};
inline constexpr sensor::Color kLoopClosureColor{226, 60, 26};

// Where a frame's map is on a canvas, and how wide lines are there.
struct MapPlacement {
  RasterFrame frame;
  int x = 0, y = 0;     // of the map's upper left pixel
  double line_px = 2.;  // width of the trajectory's line
};

// Draws a line through the nodes of every trajectory, with a light seam that sets it off from any
// label, a ring at its first node and a dot at its last. Nodes whose position is not finite are
// passed over.
void DrawTrajectories(const map::Map& map, const MapPlacement& placement, Canvas* canvas);

// Draws a line for every inter-submap constraint, from the node to the submap's origin. Constraints
// of nodes or submaps that the map does not hold are passed over.
void DrawLoopClosures(const map::Map& map, const MapPlacement& placement, Canvas* canvas);

// The marks of a trajectory's ends, for the map and for its legend.
void DrawStartMark(double x, double y, double line_px, Canvas* canvas);
void DrawEndMark(double x, double y, double line_px, Canvas* canvas);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_DRAW_TRAJECTORY_H_
