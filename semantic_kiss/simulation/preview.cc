// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/preview.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/io/atomic_file.h"

namespace semantic_kiss::simulation {
namespace {

using cartographer::sensor::Color;
using cartographer::sensor::Label;
using cartographer::sensor::LabelSet;

constexpr int kMaxPixels = 4000;
constexpr double kFinest_m = 0.2;

Color ColorOf(const LabelSet& labels, uint16_t id) {
  const std::optional<Label> label = labels.FromFileId(id);
  return label ? labels.ColorOf(*label) : Color{128, 128, 128};
}

// Maps the world's plane to pixels, north up.
class Canvas {
 public:
  explicit Canvas(const Eigen::AlignedBox2d& bounds)
      : bounds_(bounds),
        pixel_m_(std::max(kFinest_m, bounds.sizes().maxCoeff() / kMaxPixels)),
        width_(static_cast<int>(bounds.sizes().x() / pixel_m_)),
        height_(static_cast<int>(bounds.sizes().y() / pixel_m_)),
        surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_, height_),
                 cairo_surface_destroy),
        cairo_(cairo_create(surface_.get()), cairo_destroy) {}

  void DrawGround(const Ground& ground, const LabelSet& labels) {
    cairo_surface_flush(surface_.get());
    unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < height_; ++y) {
      auto* row = reinterpret_cast<uint32_t*>(data + static_cast<size_t>(y) * stride);
      for (int x = 0; x < width_; ++x) {
        const Eigen::Vector2d point(bounds_.min().x() + (x + 0.5) * pixel_m_,
                                    bounds_.max().y() - (y + 0.5) * pixel_m_);
        const Color color = ColorOf(labels, ground.MaterialAt(point).label);
        row[x] = static_cast<uint32_t>(color.red) << 16 | static_cast<uint32_t>(color.green) << 8 |
                 color.blue;
      }
    }
    cairo_surface_mark_dirty(surface_.get());
  }

  void DrawPrimitive(const Primitive& primitive, const LabelSet& labels) {
    cairo_t* cairo = cairo_.get();
    const Color color = ColorOf(labels, primitive.material.label);
    cairo_save(cairo);
    MoveOrigin(primitive.centre.head<2>());
    cairo_rotate(cairo, -std::atan2(primitive.sin_yaw, primitive.cos_yaw));
    const double x = primitive.half.x() / pixel_m_, y = primitive.half.y() / pixel_m_;
    if (primitive.shape == Shape::kBox) {
      cairo_rectangle(cairo, -x, -y, 2. * x, 2. * y);
    } else {
      cairo_arc(cairo, 0., 0., std::max(1., primitive.PlanarRadius() / pixel_m_), 0., 2. * M_PI);
    }
    const double alpha = primitive.texture == Texture::kCloud ? 0.5 : 1.;
    cairo_set_source_rgba(cairo, color.red / 255., color.green / 255., color.blue / 255., alpha);
    cairo_fill(cairo);
    cairo_restore(cairo);
  }

  void DrawRoute(const Route& route) {
    cairo_t* cairo = cairo_.get();
    for (const PlanarPose& pose : route.poses) {
      const Eigen::Vector2d pixel = ToPixel(pose.position);
      cairo_line_to(cairo, pixel.x(), pixel.y());
    }
    cairo_set_source_rgb(cairo, 0., 0., 0.);
    cairo_set_line_width(cairo, std::max(2., 0.5 / pixel_m_));
    cairo_stroke(cairo);
  }

  absl::Status Save(const std::string& path) {
    std::string png;
    const auto append = [](void* sink, const unsigned char* bytes, unsigned int size) {
      static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(bytes), size);
      return CAIRO_STATUS_SUCCESS;
    };
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append, &png);
    if (status != CAIRO_STATUS_SUCCESS) {
      return absl::InternalError(
          absl::StrCat(path, ": cannot draw: ", cairo_status_to_string(status)));
    }
    return cartographer::io::WriteFileAtomically(path, png);
  }

 private:
  Eigen::Vector2d ToPixel(const Eigen::Vector2d& point) const {
    return Eigen::Vector2d(point.x() - bounds_.min().x(), bounds_.max().y() - point.y()) / pixel_m_;
  }
  void MoveOrigin(const Eigen::Vector2d& point) {
    const Eigen::Vector2d pixel = ToPixel(point);
    cairo_translate(cairo_.get(), pixel.x(), pixel.y());
  }

  const Eigen::AlignedBox2d bounds_;
  const double pixel_m_;
  const int width_, height_;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

}  // namespace

absl::Status DrawPreview(const Simulation& simulation, const LabelSet& labels,
                         const std::string& path) {
  const World& world = simulation.world();
  Canvas canvas(world.streets().bounds());
  canvas.DrawGround(world.ground(), labels);
  // What is lower is drawn first.
  std::vector<size_t> order(world.primitives().size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return world.primitives()[a].half.z() < world.primitives()[b].half.z();
  });
  for (const size_t index : order) canvas.DrawPrimitive(world.primitives()[index], labels);
  canvas.DrawRoute(simulation.route());
  return canvas.Save(path);
}

}  // namespace semantic_kiss::simulation
