// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/cartographer/io/decoded_png.h"

#include <cairo.h>

#include <cstring>

#include "absl/strings/string_view.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

cairo_status_t ReadFrom(void* closure, unsigned char* data, unsigned int length) {
  auto* const rest = static_cast<absl::string_view*>(closure);
  if (rest->size() < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, rest->data(), length);
  rest->remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

DecodedPng DecodePng(const std::string& bytes) {
  absl::string_view rest(bytes);
  cairo_surface_t* const surface = cairo_image_surface_create_from_png_stream(ReadFrom, &rest);
  CHECK_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  CHECK_EQ(cairo_image_surface_get_format(surface), CAIRO_FORMAT_RGB24);
  DecodedPng png;
  png.width = cairo_image_surface_get_width(surface);
  png.height = cairo_image_surface_get_height(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < png.height; ++y) {
    const unsigned char* const row = cairo_image_surface_get_data(surface) + size_t{1} * y * stride;
    for (int x = 0; x < png.width; ++x) {
      uint32_t pixel;
      std::memcpy(&pixel, row + x * sizeof(pixel), sizeof(pixel));
      png.pixels.push_back(pixel | 0xff000000u);
    }
  }
  cairo_surface_destroy(surface);
  return png;
}

}  // namespace cartographer::io
