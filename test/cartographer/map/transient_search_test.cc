// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/transient_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/cartographer/map/visited_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::PlanarPose;
using semantic_kiss_testing::Sketch;
using semantic_kiss_testing::SketchLabel;
using ::testing::ElementsAre;

// Where a 3 x 1 submap has transient cells, as a sketch, for each submap of the map.
std::vector<std::string> Search(const Map& map, const proto::TransientOptions& options) {
  sensor::LabelMask standing;
  standing.Insert(SketchLabel("car"));
  standing.Insert(sensor::kUnlabeled);
  std::vector<std::string> sketches;
  for (const CellSet& cells : TransientSearch(options, standing, map).Search(map)) {
    std::string& sketch = sketches.emplace_back();
    for (int x = 0; x < 3; ++x) sketch += cells.Contains({x, 0}) ? 'x' : '.';
  }
  return sketches;
}

std::vector<std::string> Search(const std::vector<VisitingSubmap>& submaps) {
  return Search(VisitedMap(submaps), SharpTransientOptions());
}

TEST(TransientSearchTest, ACarThatLeftIsFoundWhereTheGroundWasSeen) {
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"RR."}}}), ElementsAre("xx.", "..."));
  // Whatever came first.
  EXPECT_THAT(Search({{0., {"RR."}}, {100., {"CCC"}}}), ElementsAre("...", "xx."));
  EXPECT_THAT(Search({{0., {"UUU"}}, {100., {"RR."}}}), ElementsAre("xx.", "..."));
}

TEST(TransientSearchTest, WhatBothVisitsSawStays) {
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"CcU"}}}), ElementsAre("...", "..."));
}

TEST(TransientSearchTest, OtherLabelsNeitherGoNorSayAnything) {
  EXPECT_THAT(Search({{0., {"BPB"}}, {100., {"RRR"}}}), ElementsAre("...", "..."));
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"BBP"}}}), ElementsAre("...", "..."));
}

TEST(TransientSearchTest, AVisitEndsWhenMoreTimePasses) {
  EXPECT_THAT(Search({{0., {"CCC"}}, {29.9, {"RRR"}}}), ElementsAre("...", "..."));
  EXPECT_THAT(Search({{0., {"CCC"}}, {30., {"RRR"}}}), ElementsAre("xxx", "..."));
  // It goes on as long as the place is in sight.
  EXPECT_THAT(Search({{0., {"CCC"}}, {20., {"..R"}}, {40., {"RRR"}}}),
              ElementsAre("...", "...", "..."));
}

TEST(TransientSearchTest, AnotherTrajectoryIsAnotherVisit) {
  EXPECT_THAT(Search({{0., {"CCC"}, 0}, {0., {"RRR"}, 1}}), ElementsAre("xxx", "..."));
  Map map = VisitedMap({{0., {"CCC"}, 0}, {0., {"RRR"}, 0}, {0., {"RRR"}, 1}});
  map.nodes.clear();  // no times, so trajectories alone tell visits apart
  map.submaps.erase({1, 0});
  EXPECT_THAT(Search(map, SharpTransientOptions()), ElementsAre("...", "..."));
}

// From behind the first submap sees the car, from before the second one only the ground behind it.
TEST(TransientSearchTest, AVisitTellsAsAWhole) {
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"CCC"}}, {110., {"RRR"}}}),
              ElementsAre("...", "...", "..."));
}

TEST(TransientSearchTest, OneVisitOutOfManyIsEnough) {
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"CCC"}}, {200., {"R.."}}, {300., {"CCC"}}}),
              ElementsAre("x..", "x..", "...", "x.."));
}

TEST(TransientSearchTest, ToleranceReachesBeyondTheCell) {
  proto::TransientOptions options = SharpTransientOptions();
  options.set_tolerance_m(1.);
  // The ground beside the cell is enough, a car beside it is one too many.
  EXPECT_THAT(Search(VisitedMap({{0., {"C.."}}, {100., {".R."}}}), options),
              ElementsAre("x..", "..."));
  EXPECT_THAT(Search(VisitedMap({{0., {"C.."}}, {100., {"..R"}}}), options),
              ElementsAre("...", "..."));
  EXPECT_THAT(Search(VisitedMap({{0., {"C.."}}, {100., {"Rc."}}}), options),
              ElementsAre("...", "..."));
}

TEST(TransientSearchTest, FewWrongLabelsDoNotMakeACar) {
  proto::TransientOptions options = SharpTransientOptions();
  Map map = VisitedMap({{0., {"CCC"}}, {100., {"RRR"}}});
  auto submap = std::make_shared<submap::Submap>(*map.submaps.at({0, 1}).submap);
  submap->grid.AddHits(SketchLabel("car"), {0, 0}, 1);  // of 10
  submap->grid.AddHits(SketchLabel("car"), {1, 0}, 2);
  map.submaps[{0, 1}].submap = submap;
  // Nor is the wrong label a car for the first visit, which did see one.
  EXPECT_THAT(Search(map, options), ElementsAre("x.x", "..."));
  options.set_max_movable_share(0.);
  EXPECT_THAT(Search(map, options), ElementsAre("..x", "..."));
  options.set_min_ground_hits(11);
  EXPECT_THAT(Search(map, options), ElementsAre("...", "..."));
}

TEST(TransientSearchTest, BridgesSayNothingAboutTheRoadBelow) {
  const transform::Rigid3d above = transform::Rigid3d::Translation({0., 0., 6.});
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"RRR"}, 0, above}}), ElementsAre("...", "..."));
  const transform::Rigid3d uphill = transform::Rigid3d::Translation({0., 0., 2.9});
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"RRR"}, 0, uphill}}), ElementsAre("xxx", "..."));
}

TEST(TransientSearchTest, SubmapsMayLieAnyhow) {
  // The second one is turned by half a turn about the middle of the first.
  EXPECT_THAT(Search({{0., {"CCC"}}, {100., {"..R"}, 0, PlanarPose(3., 1., M_PI)}}),
              ElementsAre("x..", "..."));
  // Far from the origin, over the border between places.
  for (const double x : {-1000., 126., 127., 128., 5000.}) {
    EXPECT_THAT(Search({{0., {"CCC"}, 0, PlanarPose(x, -x, 0.)},
                        {100., {"RR."}, 0, PlanarPose(x, -x, 0.)}}),
                ElementsAre("xx.", "..."))
        << x;
  }
}

}  // namespace
}  // namespace cartographer::map
