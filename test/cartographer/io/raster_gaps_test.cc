// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/raster_gaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test/cartographer/io/on_threads.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::RasterFromSketch;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabels;
using semantic_kiss_testing::SketchOf;

// Pixels are 1 m wide.
Sketch Filled(const Sketch& sketch, double width_m) {
  SemanticRaster raster = RasterFromSketch(sketch);
  FillGaps(SketchLabels().WithRole(sensor::LabelRole::kGround), width_m, &raster);
  return SketchOf(raster);
}

TEST(FillGapsTest, BridgesUpToTheWidth) {
  EXPECT_EQ(Filled({"R..R"}, 3.), Sketch{"RrrR"});
  EXPECT_EQ(Filled({"R..R"}, 2.9), Sketch{"R..R"});
  EXPECT_EQ(Filled({"R", ".", "R"}, 2.), (Sketch{"R", "r", "R"}));
  EXPECT_EQ(Filled({"R..", "...", "..R"}, 2.9), (Sketch{"R..", ".r.", "..R"}));
  EXPECT_EQ(Filled({"R..", "...", "..R"}, 2.8), (Sketch{"R..", "...", "..R"}));
  EXPECT_EQ(Filled({"..S", "...", "S.."}, 3.), (Sketch{"..S", ".s.", "S.."}));
  EXPECT_EQ(Filled({"R.R"}, 0.), Sketch{"R.R"});
}

TEST(FillGapsTest, NeedsOneLabelOnBothSides) {
  EXPECT_EQ(Filled({"R..S"}, 10.), Sketch{"R..S"});
  EXPECT_EQ(Filled({"R..."}, 10.), Sketch{"R..."});
  EXPECT_EQ(Filled({"R.B.R"}, 10.), Sketch{"R.B.R"});
  EXPECT_EQ(Filled({"R.U.R"}, 10.), Sketch{"R.U.R"});
}

TEST(FillGapsTest, FillsNothingButTheGivenLabels) {
  EXPECT_EQ(Filled({"B.B.C.C.P.P.U.U"}, 10.), Sketch{"B.B.C.C.P.P.U.U"});
}

TEST(FillGapsTest, TheClosestPairDecides) {
  EXPECT_EQ(Filled({"..S..", "R...R", "..S.."}, 5.), (Sketch{"..S..", "RrsrR", "..S.."}));
  EXPECT_EQ(Filled({"..S..", ".....", "R...R", ".....", ".....", "..S.."}, 5.)[2], "RrrrR");
}

TEST(FillGapsTest, ASecondPassClosesMeshes) {
  EXPECT_EQ(Filled({"R..R", "....", "....", "R..R"}, 3.), (Sketch{"RrrR", "rrrr", "rrrr", "RrrR"}));
}

TEST(FillGapsTest, SeenPixelsStayAsTheyAre) {
  const Sketch seen{"RSRSRS", "BCPUBC"};
  EXPECT_EQ(Filled(seen, 10.), seen);
}

// The definition, pixel by pixel: `known` says which pixels count as seen.
SemanticRaster OnePassByDefinition(const SemanticRaster& raster, const std::vector<bool>& known,
                                   double limit_px) {
  SemanticRaster result = raster;
  const sensor::LabelMask ground = SketchLabels().WithRole(sensor::LabelRole::kGround);
  const RasterFrame& frame = raster.frame;
  const auto nearest = [&](int column, int row, int dx, int dy) {
    for (int steps = 1;; ++steps) {
      const int x = column + steps * dx, y = row + steps * dy;
      if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) {
        return std::make_pair(sensor::kUnlabeled, 1e9);
      }
      const size_t index = raster.IndexOf(x, y);
      if (known[index]) return std::make_pair(raster.labels[index], steps * std::hypot(dx, dy));
    }
  };
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      if (known[raster.IndexOf(column, row)]) continue;
      double best_px = limit_px + 1e-9;
      bool found = false;
      for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {-1, 1}}) {
        const auto [ahead, ahead_px] = nearest(column, row, dx, dy);
        const auto [behind, behind_px] = nearest(column, row, -dx, -dy);
        const double px = ahead_px + behind_px;
        if (ahead != behind || !ground.Contains(ahead) || px > best_px) continue;
        if (found && px > best_px - 1e-6) continue;
        found = true;
        best_px = px;
        result.labels[raster.IndexOf(column, row)] = ahead;
      }
    }
  }
  return result;
}

SemanticRaster FilledByDefinition(SemanticRaster raster, double limit_px) {
  std::vector<bool> known(raster.hits.size());
  for (int pass = 0; pass < 2; ++pass) {
    for (size_t i = 0; i < known.size(); ++i) {
      known[i] = raster.hits[i] > 0.f || raster.labels[i] != sensor::kUnlabeled;
    }
    raster = OnePassByDefinition(raster, known, limit_px);
  }
  return raster;
}

TEST(FillGapsTest, EqualsTheDefinitionOnAnyRaster) {
  for (int seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> side(1, 30);
    Sketch sketch(side(random), std::string(side(random), '.'));
    for (std::string& row : sketch) {
      for (char& character : row) {
        if (random() % 6 == 0) character = "RRRSSBU"[random() % 7];
      }
    }
    const SemanticRaster raster = RasterFromSketch(sketch);
    const double width = 1. + seed % 8;
    EXPECT_EQ(Filled(sketch, width), SketchOf(FilledByDefinition(raster, width))) << seed;
  }
}

TEST(FillGapsTest, ThreadsDoNotShow) {
  std::mt19937 random(5);
  Sketch sketch(300, std::string(400, '.'));
  for (std::string& row : sketch) {
    for (char& character : row) {
      if (random() % 10 == 0) character = random() % 2 ? 'R' : 'S';
    }
  }
  const auto one = OnThreads(1, [&] { return Filled(sketch, 6.); });
  const auto four = OnThreads(4, [&] { return Filled(sketch, 6.); });
  EXPECT_EQ(one, four);
}

}  // namespace
}  // namespace cartographer::io
