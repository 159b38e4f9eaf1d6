// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/draw_canvas.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "absl/strings/str_cat.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

cairo_status_t AppendTo(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

absl::StatusOr<Canvas> Canvas::Create(int width, int height, sensor::Color background) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height),
                  cairo_surface_destroy);
  Context context(cairo_create(surface.get()), cairo_destroy);
  const cairo_status_t status = cairo_status(context.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    return absl::ResourceExhaustedError(
        absl::StrCat("cannot make a picture of ", width, " x ", height,
                     " pixels: ", cairo_status_to_string(status), "; ask for fewer pixels"));
  }
  // Nothing of the desktop's settings may show in the bytes.
  cairo_font_options_t* font = cairo_font_options_create();
  cairo_font_options_set_antialias(font, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(font, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(font, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context.get(), font);
  cairo_font_options_destroy(font);
  Canvas canvas(std::move(surface), std::move(context));
  canvas.SetColor(background);
  cairo_paint(canvas.context());
  return canvas;
}

int Canvas::width() const { return cairo_image_surface_get_width(surface_.get()); }
int Canvas::height() const { return cairo_image_surface_get_height(surface_.get()); }

void Canvas::SetColor(sensor::Color color, double opacity) {
  cairo_set_source_rgba(context(), color.red / 255., color.green / 255., color.blue / 255.,
                        opacity);
}

void Canvas::DrawPixels(const std::vector<uint32_t>& pixels, int image_width, int x, int y) {
  CHECK_GT(image_width, 0);
  const int image_height = static_cast<int>(pixels.size() / image_width);
  CHECK_EQ(pixels.size(), static_cast<size_t>(image_width) * image_height);
  CHECK(x >= 0 && y >= 0 && x + image_width <= width() && y + image_height <= height());
  cairo_surface_flush(surface_.get());
  unsigned char* data = cairo_image_surface_get_data(surface_.get());
  const size_t stride = cairo_image_surface_get_stride(surface_.get());
  for (int row = 0; row < image_height; ++row) {
    std::memcpy(data + (y + row) * stride + x * sizeof(uint32_t),
                &pixels[static_cast<size_t>(row) * image_width], image_width * sizeof(uint32_t));
  }
  cairo_surface_mark_dirty(surface_.get());
}

void Canvas::SelectFont(const TextStyle& style) {
  cairo_select_font_face(context(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context(), style.size_px);
}

std::string Canvas::Drawable(absl::string_view text) {
  // Asked of the font, since an invalid string would stop the context for good.
  cairo_glyph_t* glyphs = nullptr;
  int num_glyphs = 0;
  const cairo_status_t status = cairo_scaled_font_text_to_glyphs(
      cairo_get_scaled_font(context()), 0., 0., text.data(), static_cast<int>(text.size()), &glyphs,
      &num_glyphs, nullptr, nullptr, nullptr);
  cairo_glyph_free(glyphs);
  std::string drawable(text);
  if (status == CAIRO_STATUS_SUCCESS) return drawable;
  std::replace_if(
      drawable.begin(), drawable.end(), [](char c) { return static_cast<unsigned char>(c) > 126; },
      '?');
  return drawable;
}

double Canvas::TextWidth(absl::string_view text, const TextStyle& style) {
  SelectFont(style);
  cairo_text_extents_t extents;
  cairo_text_extents(context(), Drawable(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::DrawText(absl::string_view text, double x, double y, const TextStyle& style) {
  SelectFont(style);
  SetColor(style.color);
  cairo_move_to(context(), x, y);
  cairo_show_text(context(), Drawable(text).c_str());
  cairo_new_path(context());
}

absl::StatusOr<std::string> Canvas::ToPng() const {
  cairo_status_t status = cairo_status(context());
  std::string bytes;
  if (status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png_stream(surface_.get(), AppendTo, &bytes);
  }
  if (status != CAIRO_STATUS_SUCCESS) {
    return absl::InternalError(
        absl::StrCat("cannot draw the picture: Cairo says ", cairo_status_to_string(status)));
  }
  return bytes;
}

}  // namespace cartographer::io
