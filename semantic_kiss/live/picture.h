// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LIVE_PICTURE_H_
#define SEMANTIC_KISS_LIVE_PICTURE_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cartographer/io/raster_frame.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/submap/id.h"
#include "cartographer/submap/placed.h"
#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/live/snapshot.h"

namespace semantic_kiss::live {

// The map of a run from above, while it grows: a rough one, for the report has the fine one. Each
// pixel has the label that any finished submap saw there most often. A submap is drawn once; when
// loop closures have moved those that are drawn by more than a pixel, all are drawn anew.
class Picture {
 public:
  explicit Picture(const cartographer::sensor::LabelSet& labels) : labels_(labels) {}

  // Takes in what is new; whether there was anything. Submaps whose pose is not finite are left
  // out.
  bool Draw(const Snapshot& snapshot);

  // How it lies in the map frame; of size 0 before anything is drawn.
  const cartographer::io::RasterFrame& frame() const { return frame_; }
  // The bytes of a PNG file, transparent where nothing was seen; empty before anything is drawn.
  std::string Png() const;

 private:
  using PlacedSubmap = cartographer::submap::PlacedSubmap;
  struct Pixel {
    uint16_t hits = 0;  // 0: nothing was seen
    cartographer::sensor::Label label = cartographer::sensor::kUnlabeled;
  };

  bool AnyMoved(const Snapshot& snapshot) const;
  void Add(const PlacedSubmap& placed);
  // Makes room for a box of the map frame, by more pixels or, once these are too many, larger ones.
  void MakeRoom(const Eigen::AlignedBox2d& box);
  // Resamples what is drawn so far.
  void Reframe(const cartographer::io::RasterFrame& frame);
  void Take(const Eigen::Vector2d& position, const Pixel& seen);

  const cartographer::sensor::LabelSet labels_;
  cartographer::io::RasterFrame frame_;
  std::vector<Pixel> pixels_;
  std::map<cartographer::submap::SubmapId, cartographer::transform::Rigid3d> drawn_;
};

}  // namespace semantic_kiss::live

#endif  // SEMANTIC_KISS_LIVE_PICTURE_H_
