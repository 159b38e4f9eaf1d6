// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_DRAW_CANVAS_H_
#define CARTOGRAPHER_IO_DRAW_CANVAS_H_

#include <cairo.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::io {

struct TextStyle {
  double size_px = 12.;
  bool bold = false;
  sensor::Color color;
};

// An opaque image to draw on with Cairo; x grows to the right, y down, in pixels. Text uses DejaVu
// Sans if it is installed and whatever Cairo has if not.
class Canvas {
 public:
  // Filled with one colour. Error: no memory for a canvas of this size (sides up to 32767).
  static absl::StatusOr<Canvas> Create(int width, int height, sensor::Color background);

  int width() const;
  int height() const;
  cairo_t* context() const { return context_.get(); }

  void SetColor(sensor::Color color, double opacity = 1.);

  // Copies an image of 0xffRRGGBB pixels, row by row, to (x, y); it must lie within (CHECKed).
  void DrawPixels(const std::vector<uint32_t>& pixels, int image_width, int x, int y);

  // Text that is not UTF-8 is drawn with question marks for the bytes that are not ASCII.
  double TextWidth(absl::string_view text, const TextStyle& style);
  // `y` is the line that the letters stand on.
  void DrawText(absl::string_view text, double x, double y, const TextStyle& style);

  // The bytes of a PNG file; the same for the same drawing.
  absl::StatusOr<std::string> ToPng() const;

 private:
  using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;
  using Context = std::unique_ptr<cairo_t, void (*)(cairo_t*)>;

  Canvas(Surface surface, Context context)
      : surface_(std::move(surface)), context_(std::move(context)) {}
  void SelectFont(const TextStyle& style);
  std::string Drawable(absl::string_view text);

  Surface surface_;
  Context context_;
};

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_DRAW_CANVAS_H_
