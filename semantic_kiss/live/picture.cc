// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/picture.h"

#include <algorithm>
#include <cmath>

#include "cartographer/io/submap_bounds.h"
#include "semantic_kiss/report/png.h"

namespace semantic_kiss::live {
namespace {

using cartographer::io::RasterFrame;
using cartographer::sensor::Label;
using cartographer::submap::PlacedSubmap;
using cartographer::submap::SemanticGrid;
using cartographer::transform::Rigid3d;

constexpr double kFinestPixel_m = 0.4;
constexpr int kMaxSide_px = 2400;
// Space around what is drawn, so that the picture does not grow with every submap.
constexpr double kMargin_m = 60.;
// How far from a submap's origin its turn is felt.
constexpr double kReach_m = 50.;
constexpr int kPngEffort = 1;
constexpr uint8_t kUnlabeledOpacity = 90;

Eigen::AlignedBox2d BoundsOf(const RasterFrame& frame) {
  Eigen::AlignedBox2d box;
  if (frame.size() == 0) return box;
  box.extend(frame.MapFromPixel({0., 0.}));
  box.extend(frame.MapFromPixel({double(frame.width), double(frame.height)}));
  return box;
}

// Edges fall on multiples of the pixel, so that frames of the same resolution share their pixels.
RasterFrame FrameAround(const Eigen::AlignedBox2d& box, double resolution_m) {
  RasterFrame frame;
  frame.resolution_m = resolution_m;
  const Eigen::Array2d low = (box.min().array() / resolution_m).floor();
  const Eigen::Array2d high = (box.max().array() / resolution_m).ceil();
  frame.min_x = low.x() * resolution_m;
  frame.max_y = high.y() * resolution_m;
  frame.width = static_cast<int>(high.x() - low.x());
  frame.height = static_cast<int>(high.y() - low.y());
  return frame;
}

double Moved_m(const Rigid3d& from, const Rigid3d& to) {
  const Rigid3d motion = from.inverse() * to;
  return motion.translation().head<2>().norm() +
         kReach_m * std::abs(cartographer::transform::Yaw(motion.rotation()));
}

uint8_t PaletteIndex(Label label) {
  return static_cast<uint8_t>(std::min<size_t>(cartographer::sensor::Index(label) + 1, 255));
}

}  // namespace

bool Picture::Draw(const Snapshot& snapshot) {
  bool changed = false;
  if (AnyMoved(snapshot)) {
    drawn_.clear();
    std::fill(pixels_.begin(), pixels_.end(), Pixel());
    changed = true;
  }
  for (const auto& [id, placed] : snapshot.submaps) {
    if (!placed.map_from_submap.Matrix().allFinite()) continue;
    if (!drawn_.emplace(id, placed.map_from_submap).second) continue;
    Add(placed);
    changed = true;
  }
  return changed;
}

bool Picture::AnyMoved(const Snapshot& snapshot) const {
  return std::any_of(drawn_.begin(), drawn_.end(), [&](const auto& drawn) {
    const auto now = snapshot.submaps.find(drawn.first);
    return now == snapshot.submaps.end() ||
           Moved_m(drawn.second, now->second.map_from_submap) > frame_.resolution_m;
  });
}

void Picture::Add(const PlacedSubmap& placed) {
  const Eigen::AlignedBox2d bounds =
      cartographer::io::BoundsInMap(placed.submap->grid, placed.map_from_submap);
  if (bounds.isEmpty()) return;
  MakeRoom(bounds);
  const Eigen::Isometry2d map_from_grid = cartographer::submap::MapFromGrid(placed);
  const SemanticGrid& grid = placed.submap->grid;
  constexpr int kSize = SemanticGrid::kTileSize;
  for (const auto& [index, tile] : grid.DominantTiles()) {
    for (int cell = 0; cell < kSize * kSize; ++cell) {
      if (tile.hits[cell] == 0) continue;
      const cartographer::submap::CellIndex at{index.x * kSize + cell % kSize,
                                               index.y * kSize + cell / kSize};
      Take(map_from_grid * grid.CenterOf(at), {tile.hits[cell], tile.labels[cell]});
    }
  }
}

void Picture::MakeRoom(const Eigen::AlignedBox2d& box) {
  Eigen::AlignedBox2d all = BoundsOf(frame_);
  if (!all.isEmpty() && all.contains(box)) return;
  all.extend(Eigen::AlignedBox2d(box.min().array() - kMargin_m, box.max().array() + kMargin_m));
  double resolution_m = std::max(frame_.resolution_m, kFinestPixel_m);
  while (all.sizes().maxCoeff() / resolution_m > kMaxSide_px) resolution_m *= 2.;
  Reframe(FrameAround(all, resolution_m));
}

void Picture::Reframe(const RasterFrame& frame) {
  const RasterFrame old_frame = frame_;
  const std::vector<Pixel> old_pixels = std::move(pixels_);
  frame_ = frame;
  pixels_.assign(frame.size(), Pixel());
  for (size_t i = 0; i < old_pixels.size(); ++i) {
    if (old_pixels[i].hits == 0) continue;
    const Eigen::Vector2d center(i % old_frame.width + 0.5, i / old_frame.width + 0.5);
    Take(old_frame.MapFromPixel(center), old_pixels[i]);
  }
}

void Picture::Take(const Eigen::Vector2d& position, const Pixel& seen) {
  const Eigen::Array2d at = frame_.PixelFromMap(position).array().floor();
  if ((at < 0.).any() || at.x() >= frame_.width || at.y() >= frame_.height) return;
  Pixel& pixel = pixels_[static_cast<size_t>(at.y()) * frame_.width + static_cast<size_t>(at.x())];
  const bool labeled = seen.label != cartographer::sensor::kUnlabeled;
  const bool was_labeled = pixel.label != cartographer::sensor::kUnlabeled;
  const bool beats = labeled == was_labeled ? seen.hits > pixel.hits : labeled;
  if (beats) pixel = seen;
}

std::string Picture::Png() const {
  if (pixels_.empty()) return "";
  report::PalettePicture picture{frame_.width, frame_.height, 8, "", "", ""};
  picture.palette.assign(3, '\0');
  picture.opacities.assign(1, '\0');
  for (size_t i = 0; i < std::min<size_t>(labels_.size(), 255); ++i) {
    const cartographer::sensor::Color color = labels_.ColorOf(Label{static_cast<uint8_t>(i)});
    picture.palette += {static_cast<char>(color.red), static_cast<char>(color.green),
                        static_cast<char>(color.blue)};
    picture.opacities.push_back(static_cast<char>(i == 0 ? kUnlabeledOpacity : 255));
  }
  picture.rows.reserve(frame_.size() + frame_.height);
  for (int row = 0; row < frame_.height; ++row) {
    picture.rows.push_back(0);
    const Pixel* const pixels = &pixels_[static_cast<size_t>(row) * frame_.width];
    for (int column = 0; column < frame_.width; ++column) {
      const Pixel& pixel = pixels[column];
      picture.rows.push_back(static_cast<char>(pixel.hits == 0 ? 0 : PaletteIndex(pixel.label)));
    }
  }
  return report::PngFile(picture, kPngEffort);
}

}  // namespace semantic_kiss::live
