// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_SEMANTIC_KISS_REPORT_DECODED_PNG_H_
#define TEST_SEMANTIC_KISS_REPORT_DECODED_PNG_H_

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "glog/logging.h"

namespace semantic_kiss_testing {

// A PNG file as another library reads it.
struct DecodedPng {
  int width = 0;
  int height = 0;
  std::vector<uint32_t> pixels;  // 0xAARRGGBB, colours multiplied by alpha
};

inline DecodedPng DecodePng(const std::string& png) {
  struct Source {
    const std::string& bytes;
    size_t position;
  } source{png, 0};
  const auto read = [](void* closure, unsigned char* data, unsigned int size) {
    Source* const from = static_cast<Source*>(closure);
    if (from->bytes.size() - from->position < size) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, from->bytes.data() + from->position, size);
    from->position += size;
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* const surface = cairo_image_surface_create_from_png_stream(read, &source);
  CHECK_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  CHECK_EQ(cairo_image_surface_get_format(surface), CAIRO_FORMAT_ARGB32);
  DecodedPng decoded;
  decoded.width = cairo_image_surface_get_width(surface);
  decoded.height = cairo_image_surface_get_height(surface);
  for (int row = 0; row < decoded.height; ++row) {
    const auto* const begin = reinterpret_cast<const uint32_t*>(
        cairo_image_surface_get_data(surface) + row * cairo_image_surface_get_stride(surface));
    decoded.pixels.insert(decoded.pixels.end(), begin, begin + decoded.width);
  }
  cairo_surface_destroy(surface);
  return decoded;
}

}  // namespace semantic_kiss_testing

#endif  // TEST_SEMANTIC_KISS_REPORT_DECODED_PNG_H_
