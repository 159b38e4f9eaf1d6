// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/occupancy_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "glog/logging.h"
#include "test/testing/map_sketch.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::AddSubmap;
using semantic_kiss_testing::EmptyMap;
using semantic_kiss_testing::MapFromSketch;
using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SubmapFromSketch;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

proto::RenderOptions Options() {
  proto::RenderOptions options;
  options.set_max_side_px(1000);
  return options;
}

OccupancyGrid Draw(const map::Map& map, const proto::RenderOptions& options = Options()) {
  const auto grid = DrawOccupancyGrid(map, options, "map.pgm");
  CHECK(grid.ok()) << grid.status();
  return *grid;
}

std::string Error(const map::Map& map, const proto::RenderOptions& options) {
  return std::string(DrawOccupancyGrid(map, options, "map.pgm").status().message());
}

// The pixels of a picture: '#' occupied, '-' free, '.' unknown, without the rows and columns in
// which all is unknown.
Sketch PixelsOf(const OccupancyGrid& grid) {
  int width = 0, height = 0, header = 0;
  CHECK_EQ(std::sscanf(grid.pgm.c_str(), "P5\n%d %d\n255\n%n", &width, &height, &header), 2);
  CHECK_EQ(grid.pgm.size(), header + size_t(width) * height);
  Sketch rows;
  size_t first = width, last = 0;
  for (int row = 0; row < height; ++row) {
    std::string text;
    for (int column = 0; column < width; ++column) {
      const auto value = static_cast<uint8_t>(grid.pgm[header + row * width + column]);
      CHECK(value == 0 || value == 254 || value == 205) << int{value};
      text += value == 0 ? '#' : value == 254 ? '-' : '.';
    }
    if (text.find_first_not_of('.') == std::string::npos) continue;
    first = std::min(first, text.find_first_not_of('.'));
    last = std::max(last, text.find_last_not_of('.'));
    rows.push_back(text);
  }
  for (std::string& row : rows) row = row.substr(first, last + 1 - first);
  return rows;
}

TEST(OccupancyGridTest, GroundIsFreeAndTheRestIsOccupied) {
  EXPECT_THAT(PixelsOf(Draw(MapFromSketch({"RSCB", "U.PR"}, 1.))), ElementsAre("--##", "#.#-"));
}

TEST(OccupancyGridTest, TheLabelWithMostHitsDecides) {
  map::Map map = MapFromSketch({"RRRR"}, 1., 3);
  AddSubmap(SubmapFromSketch({"BBC."}, 1., 2), transform::Rigid3d(), &map);
  AddSubmap(SubmapFromSketch({"B..."}, 1., 2), transform::Rigid3d(), &map);
  EXPECT_THAT(PixelsOf(Draw(map)), ElementsAre("#---"));
}

TEST(OccupancyGridTest, ChosenLabelsAloneAreObstacles) {
  map::Map map = MapFromSketch({"RRRR"}, 1., 1);
  AddSubmap(SubmapFromSketch({"CCBP"}, 1., 5), transform::Rigid3d(), &map);
  proto::RenderOptions options = Options();
  options.add_hide("car");
  EXPECT_THAT(PixelsOf(Draw(map, options)), ElementsAre("--##"));
  options.clear_hide();
  options.add_show("car");
  EXPECT_THAT(PixelsOf(Draw(map, options)), ElementsAre("##--"));
  options.add_hide("road");
  EXPECT_THAT(PixelsOf(Draw(map, options)), ElementsAre("##"));
}

TEST(OccupancyGridTest, GapsInTheGroundAreFilledAsInPictures) {
  proto::RenderOptions options = Options();
  EXPECT_THAT(PixelsOf(Draw(MapFromSketch({"R..R..B"}, 1.), options)), ElementsAre("-..-..#"));
  options.set_fill_gaps_m(3.);
  EXPECT_THAT(PixelsOf(Draw(MapFromSketch({"R..R..B"}, 1.), options)), ElementsAre("----..#"));
}

TEST(OccupancyGridTest, GoldenFiles) {
  const TemporaryDirectory directory;
  map::Map map = EmptyMap();
  AddSubmap(SubmapFromSketch({"RB"}, 1.), PlanarPose(100., -50., 0.), &map);
  ASSERT_TRUE(WriteOccupancyGrid(map, Options(), directory / "my map.pgm").ok());
  EXPECT_EQ(ReadText(directory / "my map.yaml"),
            "image: \"my map.pgm\"\n"
            "mode: trinary\n"
            "resolution: 1\n"
            "origin: [96.6862915, -53.372583, 0]\n"
            "negate: 0\n"
            "occupied_thresh: 0.65\n"
            "free_thresh: 0.196\n");
  std::string pixels(34 * 34, static_cast<char>(205));
  // The origin is the lower left corner of the lowest row. The road's cell at (100, -50) has its
  // centre 3.8 m to the right of it and 3.9 m above.
  pixels[(33 - 3) * 34 + 3] = static_cast<char>(254);
  pixels[(33 - 3) * 34 + 4] = 0;
  EXPECT_TRUE(ReadText(directory / "my map.pgm") == "P5\n34 34\n255\n" + pixels);
}

TEST(OccupancyGridTest, ResolutionIsTheCellsUnlessGiven) {
  EXPECT_THAT(Draw(MapFromSketch({"R"}, 0.25)).yaml, HasSubstr("\nresolution: 0.25\n"));
  proto::RenderOptions options = Options();
  options.set_resolution_m(0.05);
  EXPECT_THAT(Draw(MapFromSketch({"R"}, 0.25), options).yaml, HasSubstr("\nresolution: 0.05\n"));
}

TEST(OccupancyGridTest, OnlyAResolutionOfOnesOwnIsNeverCoarsened) {
  proto::RenderOptions options = Options();
  options.set_max_side_px(16);
  const map::Map map = MapFromSketch({"R"}, 1.);
  EXPECT_THAT(Draw(map, options).yaml, HasSubstr("\nresolution: 2.121320344\n"));
  options.set_resolution_m(1.);
  EXPECT_EQ(Error(map, options),
            "resolution: with pixels of 1 m the map is larger than 16 pixels a side (max_side_px); "
            "give 2.13 m or more");
  options.set_resolution_m(2.13);
  EXPECT_THAT(Draw(map, options).yaml, HasSubstr("\nresolution: 2.13\n"));
}

// A limit on file sizes stands for a disk that has room for the picture, but not for its
// description, which a long name makes the larger of the two.
TEST(OccupancyGridTest, AnEarlierPairIsNotLeftHalfReplaced) {
  const TemporaryDirectory directory;
  const std::string name = directory / std::string(200, 'm');
  WriteText(name + ".pgm", "old picture");
  WriteText(name + ".yaml", "old description");
  proto::RenderOptions options = Options();
  options.set_max_side_px(8);
  struct rlimit old_limit;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit limit = old_limit;
  limit.rlim_cur = 200;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const absl::Status status = WriteOccupancyGrid(MapFromSketch({"R"}, 1.), options, name + ".pgm");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);

  EXPECT_THAT(std::string(status.message()), HasSubstr(".yaml: cannot write: File too large"));
  EXPECT_EQ(ReadText(name + ".pgm"), "old picture");
  EXPECT_EQ(ReadText(name + ".yaml"), "old description");
}

TEST(OccupancyGridTest, ErrorsLeaveNothing) {
  EXPECT_THAT(Error(EmptyMap(), Options()), HasSubstr("nothing to draw"));
  proto::RenderOptions options = Options();
  options.add_hide("cra");
  EXPECT_THAT(Error(MapFromSketch({"R"}, 1.), options), HasSubstr("hide: "));
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory / "map.yaml");
  const absl::Status status =
      WriteOccupancyGrid(MapFromSketch({"R"}, 1.), Options(), directory / "map.pgm");
  EXPECT_THAT(std::string(status.message()), HasSubstr("map.yaml"));
  EXPECT_FALSE(std::filesystem::exists(directory / "map.pgm"));
}

}  // namespace
}  // namespace cartographer::io
