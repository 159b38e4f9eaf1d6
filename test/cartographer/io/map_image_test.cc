// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "cartographer/io/raster_shading.h"
#include "glog/logging.h"
#include "test/cartographer/io/decoded_png.h"
#include "test/cartographer/io/on_threads.h"
#include "test/testing/map_sketch.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddNode;
using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::MapFromSketch;
using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using semantic_kiss_testing::SketchLabels;
using semantic_kiss_testing::SubmapFromSketch;
using semantic_kiss_testing::WholeFrame;
using ::testing::HasSubstr;

// The raster alone, a pixel a cell of 1 m, nothing cropped or filled.
proto::RenderOptions PlainOptions() {
  proto::RenderOptions options;
  options.set_resolution_m(1.);
  options.set_max_side_px(1000);
  return options;
}

DecodedPng Render(const map::Map& map, const proto::RenderOptions& options) {
  const auto bytes = RenderMapImage(map, options);
  CHECK(bytes.ok()) << bytes.status();
  return DecodePng(*bytes);
}

// The pixel of a picture without frame at a position in the map.
uint32_t At(const DecodedPng& png, const map::Map& map, double x, double y) {
  const Eigen::Vector2d pixel = WholeFrame(map, 1.).PixelFromMap({x, y});
  return png.At(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
}

uint32_t Pixel(sensor::Color color) {
  return 0xff000000u | color.red << 16 | color.green << 8 | color.blue;
}
uint32_t BasePixel(const char* label) {
  return Pixel(BaseColor(SketchLabels(), SketchLabel(label)));
}

// Nearer to the first color than to the second.
bool IsNearer(uint32_t pixel, uint32_t first, uint32_t second) {
  const auto distance = [pixel](uint32_t color) {
    int sum = 0;
    for (const int shift : {0, 8, 16}) {
      sum += std::abs(int(pixel >> shift & 255) - int(color >> shift & 255));
    }
    return sum;
  };
  return distance(first) < distance(second);
}

TEST(MapImageTest, ShowsColorsWhereTheLabelsAre) {
  const map::Map map = MapFromSketch({"RRRR", "SSSS", "BBBB"}, 1.);
  const DecodedPng png = Render(map, PlainOptions());
  EXPECT_EQ(At(png, map, 1.5, 2.5), BasePixel("road"));
  EXPECT_EQ(At(png, map, 3.5, 1.5), BasePixel("sidewalk"));
  EXPECT_TRUE(IsNearer(At(png, map, 2.5, 0.5), BasePixel("building"), Pixel(kBackgroundColor)));
  EXPECT_EQ(At(png, map, 6.5, 0.5), Pixel(kBackgroundColor));
}

TEST(MapImageTest, HidingUncoversWhatLiesBeneath) {
  map::Map map = MapFromSketch({"RRRR"}, 1., 1);
  AddSubmap(SubmapFromSketch({".CC."}, 1., 5), transform::Rigid3d(), &map);
  proto::RenderOptions options = PlainOptions();
  EXPECT_TRUE(
      IsNearer(At(Render(map, options), map, 1.5, 0.5), BasePixel("car"), BasePixel("road")));
  options.add_hide("car");
  EXPECT_EQ(At(Render(map, options), map, 1.5, 0.5), BasePixel("road"));
}

TEST(MapImageTest, UnknownNamesToHideAreAnError) {
  proto::RenderOptions options = PlainOptions();
  options.add_hide("cra");
  const auto result = RenderMapImage(MapFromSketch({"R"}, 1.), options);
  EXPECT_FALSE(result.ok());
  EXPECT_THAT(std::string(result.status().message()), HasSubstr("hide"));
  EXPECT_THAT(std::string(result.status().message()), HasSubstr("cra"));
}

TEST(MapImageTest, AnEmptyMapIsAnError) {
  const auto result = RenderMapImage(EmptyMap(), PlainOptions());
  EXPECT_EQ(result.status().code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(result.status().message()), HasSubstr("nothing to draw"));
}

TEST(MapImageTest, TurnedSubmapsHaveNoHoles) {
  map::Map map = EmptyMap();
  AddSubmap(SubmapFromSketch(Sketch(40, std::string(40, 'R')), 1.), PlanarPose(5., 7., 0.6), &map);
  const DecodedPng png = Render(map, PlainOptions());
  for (double x = 1.5; x < 38.5; x += 0.5) {
    for (double y = 1.5; y < 38.5; y += 0.5) {
      const Eigen::Vector3d position = PlanarPose(5., 7., 0.6) * Eigen::Vector3d(x, y, 0.);
      ASSERT_EQ(At(png, map, position.x(), position.y()), BasePixel("road")) << x << " " << y;
    }
  }
}

TEST(MapImageTest, HugeExtentsAreBounded) {
  map::Map map = MapFromSketch({"R"}, 0.1);
  AddSubmap(SubmapFromSketch({"B"}, 0.1), PlanarPose(1e9, -1e9, 1.), &map);
  proto::RenderOptions options = PlainOptions();
  options.set_resolution_m(0.01);
  options.set_max_side_px(300);
  const DecodedPng plain = Render(map, options);
  EXPECT_EQ(plain.width, 300);
  EXPECT_EQ(plain.height, 300);
  options.set_draw_frame(true);
  options.set_fill_gaps_m(20.);
  EXPECT_LT(Render(map, options).width, 600);
}

// Overlapping submaps with grids and clouds, nodes, closures: something of everything.
map::Map RichMap() {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> cell(0, 99), label(0, 5);
  std::uniform_real_distribution<float> uniform(0.f, 20.f);
  map::Map map = EmptyMap();
  for (int i = 0; i < 8; ++i) {
    auto submap = std::make_shared<submap::Submap>(0.2);
    for (int j = 0; j < 3000; ++j) {
      const sensor::Label chosen{static_cast<uint8_t>(label(random))};
      submap->grid.AddHits(chosen, {cell(random), cell(random)});
      submap->cloud.positions.emplace_back(uniform(random), uniform(random),
                                           0.2f * uniform(random));
      submap->cloud.labels.push_back(chosen);
      submap->cloud.certainties.push_back(1.f);
    }
    AddSubmap(submap, PlanarPose(6. * i, 2. * i, 0.2 * i), &map);
    AddNode({6. * i, 2. * i, 1.}, &map);
  }
  map::Constraint closure;
  closure.kind = map::Constraint::Kind::kInterSubmap;
  closure.node_id = {0, 7};
  map.constraints.push_back(closure);
  return map;
}

proto::RenderOptions FullOptions() {
  proto::RenderOptions options;
  options.set_max_side_px(800);
  options.set_crop_share(0.01);
  options.set_fill_gaps_m(1.);
  options.set_draw_trajectory(true);
  options.set_draw_loop_closures(true);
  options.set_draw_frame(true);
  options.set_title("Everything at once");
  return options;
}

TEST(MapImageTest, BytesDoNotDependOnThreads) {
  const map::Map map = RichMap();
  const auto one = OnThreads(1, [&] { return *RenderMapImage(map, FullOptions()); });
  const auto four = OnThreads(4, [&] { return *RenderMapImage(map, FullOptions()); });
  EXPECT_TRUE(one == four);
  EXPECT_GT(one.size(), 10000);
}

TEST(MapImageTest, IsWrittenWhole) {
  const std::string path = ::testing::TempDir() + "/map_image_test.png";
  ASSERT_TRUE(WriteMapImage(RichMap(), FullOptions(), path).ok());
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_TRUE(bytes == *RenderMapImage(RichMap(), FullOptions()));

  // What cannot be drawn leaves the old picture alone.
  EXPECT_FALSE(WriteMapImage(EmptyMap(), FullOptions(), path).ok());
  EXPECT_EQ(std::filesystem::file_size(path), bytes.size());
  std::filesystem::remove(path);
}

TEST(MapImageTest, ADirectoryThatDoesNotExistIsAnError) {
  const absl::Status status = WriteMapImage(RichMap(), FullOptions(), "/nonexistent/map.png");
  EXPECT_THAT(std::string(status.message()), HasSubstr("/nonexistent/map.png"));
}

}  // namespace
}  // namespace cartographer::io
