// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/utf8.h"

#include <cstddef>
#include <cstdint>

namespace cartographer::common {
namespace {

// How many continuation bytes follow a lead byte, and between which bounds the first of them must
// lie; the others lie in [0x80, 0xBF].
struct Sequence {
  size_t num_continuations;
  uint8_t first_min, first_max;
};

bool FindSequence(uint8_t lead, Sequence* sequence) {
  if (lead < 0x80) {
    *sequence = {0, 0, 0};
  } else if (lead >= 0xC2 && lead <= 0xDF) {
    *sequence = {1, 0x80, 0xBF};
  } else if (lead >= 0xE0 && lead <= 0xEF) {
    *sequence = {2, uint8_t(lead == 0xE0 ? 0xA0 : 0x80), uint8_t(lead == 0xED ? 0x9F : 0xBF)};
  } else if (lead >= 0xF0 && lead <= 0xF4) {
    *sequence = {3, uint8_t(lead == 0xF0 ? 0x90 : 0x80), uint8_t(lead == 0xF4 ? 0x8F : 0xBF)};
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool IsUtf8(absl::string_view bytes) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(bytes[i]); };
  for (size_t i = 0; i < bytes.size(); ++i) {
    Sequence sequence;
    if (!FindSequence(byte(i), &sequence)) return false;
    if (bytes.size() - i <= sequence.num_continuations) return false;
    for (size_t k = 1; k <= sequence.num_continuations; ++k) {
      const uint8_t min = k == 1 ? sequence.first_min : 0x80;
      const uint8_t max = k == 1 ? sequence.first_max : 0xBF;
      if (byte(i + k) < min || byte(i + k) > max) return false;
    }
    i += sequence.num_continuations;
  }
  return true;
}

}  // namespace cartographer::common
