// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "cartographer/common/parallel.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

// Share of the label's own colour in the mix with the background.
constexpr float kGroundStrength = 0.75f;
constexpr float kFilledStrength = 0.93f;  // of the seen ground's
constexpr float kObjectStrength = 0.85f;
constexpr float kFaintStrength = 0.18f;  // of unlabeled hits beside labeled ones
// What the deepest shadow takes of the light.
constexpr float kShadowStrength = 0.36f;
constexpr sensor::Color kUnlabeledColor{90, 92, 96};
// Size of the marks of critical labels: radius of the core, width of the rim.
constexpr double kMarkRadius_m = 0.1;
constexpr double kRimWidth_m = 0.06;
constexpr size_t kRowsPerChunk = 16;

using Rgb = Eigen::Array3f;

Rgb ToRgb(sensor::Color color) { return {float(color.red), float(color.green), float(color.blue)}; }

sensor::Color ToColor(const Rgb& rgb) {
  const auto channel = [&](int i) { return static_cast<uint8_t>(std::lround(rgb[i])); };
  return {channel(0), channel(1), channel(2)};
}

uint32_t Pack(const Rgb& rgb) {
  const auto channel = [&](int i) {
    return static_cast<uint32_t>(std::lround(std::clamp(rgb[i], 0.f, 255.f)));
  };
  return 0xff000000u | channel(0) << 16 | channel(1) << 8 | channel(2);
}

Rgb Mix(const Rgb& below, const Rgb& above, float strength) {
  return below + (above - below) * strength;
}

// Per label the hits of its pixels, on a logarithmic scale that needs no sorting.
class HitHistogram {
 public:
  void Add(sensor::Label label, float hits) { ++bins_[sensor::Index(label)][BinOf(hits)]; }

  void Add(const HitHistogram& other) {
    for (size_t label = 0; label < bins_.size(); ++label) {
      for (int bin = 0; bin < kNumBins; ++bin) bins_[label][bin] += other.bins_[label][bin];
    }
  }

  // Binary logarithm of the median; 0 for a label that has no pixels.
  float Log2Median(sensor::Label label) const {
    const auto& bins = bins_[sensor::Index(label)];
    int64_t total = 0;
    for (const int64_t count : bins) total += count;
    if (total == 0) return 0.f;
    int64_t below = 0;
    int bin = 0;
    while ((below += bins[bin]) * 2 < total) ++bin;
    return (bin - kZeroBin + 0.5f) / kBinsPerOctave;
  }

  bool Has(sensor::Label label) const {
    const auto& bins = bins_[sensor::Index(label)];
    return std::any_of(bins.begin(), bins.end(), [](int64_t count) { return count > 0; });
  }

 private:
  static constexpr int kBinsPerOctave = 4;
  static constexpr int kZeroBin = 40;  // hits are shares of a pixel, down to 2^-10
  static constexpr int kNumBins = 160;

  static int BinOf(float hits) {
    const int bin = static_cast<int>(std::floor(std::log2(hits) * kBinsPerOctave)) + kZeroBin;
    return std::clamp(bin, 0, kNumBins - 1);
  }

  std::vector<std::array<int64_t, kNumBins>> bins_ =
      std::vector<std::array<int64_t, kNumBins>>(sensor::kMaxLabels);
};

HitHistogram HistogramOf(const SemanticRaster& raster) {
  constexpr size_t kChunkSize = 1 << 20;
  const auto parts = common::ParallelMapChunks<HitHistogram>(
      raster.hits.size(), kChunkSize, [&](size_t begin, size_t end) {
        HitHistogram histogram;
        for (size_t i = begin; i < end; ++i) {
          if (raster.hits[i] > 0.f) histogram.Add(raster.labels[i], raster.hits[i]);
        }
        return histogram;
      });
  HitHistogram histogram;
  for (const HitHistogram& part : parts) histogram.Add(part);
  return histogram;
}

// How one label is painted.
struct Paint {
  bool ground = false;
  Rgb rgb;
  float log2_median = 0.f;
  float strength = kObjectStrength;
};

std::vector<Paint> PaintsOf(const SemanticRaster& raster, const sensor::LabelSet& labels) {
  const HitHistogram histogram = HistogramOf(raster);
  std::vector<Paint> paints(labels.size());
  bool labeled = false;
  for (size_t i = 1; i < labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    paints[i].ground = labels.HasRole(label, sensor::LabelRole::kGround);
    paints[i].rgb = ToRgb(paints[i].ground ? BaseColor(labels, label) : labels.ColorOf(label));
    paints[i].log2_median = histogram.Log2Median(label);
    labeled = labeled || histogram.Has(label);
  }
  paints[0].rgb = ToRgb(kUnlabeledColor);
  paints[0].log2_median = histogram.Log2Median(sensor::kUnlabeled);
  if (labeled) paints[0].strength = kFaintStrength;
  return paints;
}

// A pixel that stands above the ground: 16 times the label's usual hits are as strong as it gets.
Rgb ObjectColor(const Paint& paint, const Rgb& background, float hits) {
  const float excess = std::clamp((std::log2(hits) - paint.log2_median) / 4.f, -1.f, 1.f);
  const float light = 1.f - 0.45f * std::max(0.f, excess);
  const float fullness = std::clamp(1.f + 0.55f * excess, 0.5f, 1.f / kObjectStrength);
  return Mix(background, paint.rgb * light, paint.strength * fullness);
}

Rgb PixelColor(const Paint& paint, float hits, float shadow) {
  const Rgb background = ToRgb(kBackgroundColor);
  const float light = 1.f - kShadowStrength * shadow;
  if (paint.ground) {
    return light * Mix(background, paint.rgb, hits > 0.f ? 1.f : kFilledStrength);
  }
  return hits > 0.f ? ObjectColor(paint, light * background, hits) : light * background;
}

// Paints a disc around every pixel of a critical label: first all rims, then all cores.
void DrawMarks(const SemanticRaster& raster, const sensor::LabelSet& labels,
               std::vector<uint32_t>* pixels) {
  const RasterFrame& frame = raster.frame;
  const sensor::LabelMask& critical = labels.WithRole(sensor::LabelRole::kCritical);
  std::vector<size_t> marks;
  for (size_t i = 0; i < raster.labels.size(); ++i) {
    if (raster.hits[i] > 0.f && critical.Contains(raster.labels[i])) marks.push_back(i);
  }
  const auto stamp = [&](size_t mark, double radius_px, uint32_t color) {
    const int reach = static_cast<int>(radius_px);
    const int column = static_cast<int>(mark % frame.width);
    const int row = static_cast<int>(mark / frame.width);
    for (int y = std::max(0, row - reach); y <= std::min(frame.height - 1, row + reach); ++y) {
      for (int x = std::max(0, column - reach); x <= std::min(frame.width - 1, column + reach);
           ++x) {
        if (std::hypot(x - column, y - row) > radius_px) continue;
        (*pixels)[raster.IndexOf(x, y)] = color;
      }
    }
  };
  const double core_px = std::max(1., kMarkRadius_m / frame.resolution_m);
  const double rim_px = core_px + std::max(1., kRimWidth_m / frame.resolution_m);
  for (const size_t mark : marks) stamp(mark, rim_px, Pack(ToRgb(kRimColor)));
  for (const size_t mark : marks) {
    stamp(mark, core_px, Pack(ToRgb(labels.ColorOf(raster.labels[mark]))));
  }
}

}  // namespace

sensor::Color BaseColor(const sensor::LabelSet& labels, sensor::Label label) {
  if (label == sensor::kUnlabeled) return UnlabeledColor(true);
  if (!labels.HasRole(label, sensor::LabelRole::kGround)) return labels.ColorOf(label);
  return ToColor(Mix(ToRgb(kBackgroundColor), ToRgb(labels.ColorOf(label)), kGroundStrength));
}

sensor::Color UnlabeledColor(bool beside_labels) {
  if (!beside_labels) return kUnlabeledColor;
  return ToColor(Mix(ToRgb(kBackgroundColor), ToRgb(kUnlabeledColor), kFaintStrength));
}

std::vector<uint32_t> ShadeRaster(const SemanticRaster& raster, const sensor::LabelSet& labels,
                                  const std::vector<float>& shadow) {
  CHECK_EQ(shadow.size(), raster.frame.size());
  const std::vector<Paint> paints = PaintsOf(raster, labels);
  std::vector<uint32_t> pixels(raster.frame.size());
  const size_t chunk_size = kRowsPerChunk * raster.frame.width;
  common::ParallelChunks(pixels.size(), chunk_size, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Paint& paint = paints[sensor::Index(raster.labels[i])];
      pixels[i] = Pack(PixelColor(paint, raster.hits[i], shadow[i]));
    }
  });
  DrawMarks(raster, labels, &pixels);
  return pixels;
}

}  // namespace cartographer::io
