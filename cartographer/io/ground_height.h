// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_GROUND_HEIGHT_H_
#define CARTOGRAPHER_IO_GROUND_HEIGHT_H_

#include <vector>

#include "cartographer/io/raster_frame.h"
#include "cartographer/map/map.h"

namespace cartographer::io {

// How high the ground lies within a frame: the mean height of the clouds' points with a ground
// label, over squares of a metre (of a pixel, if that is larger). Where there are none, the height
// comes from the surroundings, the wider the farther the next such point is.
class GroundHeight {
 public:
  GroundHeight(const map::Map& map, const RasterFrame& frame);

  // Whether there was any point to go by; without one, heights are 0.
  bool known() const { return known_; }

  // Height in the map frame [m] at a position, which may lie outside of the frame.
  float At(double x, double y) const;

 private:
  // A level of the pyramid; counts are 0 where nothing is known yet.
  struct Level {
    int width = 0, height = 0;
    std::vector<float> heights;
    std::vector<float> weights;
  };
  static Level Halve(const Level& fine);
  static void FillFrom(const Level& coarse, Level* fine);
  void Fill(Level finest);

  RasterFrame frame_;  // of metre-sized pixels
  std::vector<float> heights_;
  bool known_ = false;
};

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_GROUND_HEIGHT_H_
