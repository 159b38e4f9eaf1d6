// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/filter_report.h"

#include <gtest/gtest.h>

#include "test/testing/small_map.h"

namespace cartographer::map {
namespace {

using semantic_kiss_testing::StreetLabels;

TEST(FilterReportTest, IsEmptyUnlessSomethingWasRemoved) {
  FilterReport report;
  EXPECT_TRUE(report.IsEmpty());
  report.labels.resize(3);
  EXPECT_TRUE(report.IsEmpty());
  report.labels[2].node_points = 1;
  EXPECT_FALSE(report.IsEmpty());
  FilterReport trajectory;
  trajectory.trajectories.submaps = 1;  // an empty one
  EXPECT_FALSE(trajectory.IsEmpty());
}

TEST(FilterReportTest, HistoryNamesFlagsAndLosses) {
  proto::FilterOptions options;
  options.add_remove("car");
  options.add_remove("pole");
  options.add_remove_roles("movable");
  options.set_min_hits(3);
  options.add_box(-1.5);
  options.add_box(12345.6789);
  options.set_outside(true);
  options.add_trajectories(4);
  FilterReport report;
  report.labels = {{0, 0, 0}, {0, 0, 0}, {7, 8, 9}, {0, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(HistoryLine(options, report, StreetLabels()),
            "filter --remove=car,pole --remove_role=movable --box=-1.5,12345.6789 --outside "
            "--trajectory=4 --min_hits=3: removed 7 hits, 8 submap points, 9 node points of car; 0 "
            "hits, 0 submap points, 1 node points of pole");
}

TEST(FilterReportTest, HistoryNamesTrajectoriesAndTransientOptions) {
  proto::FilterOptions options;
  options.add_keep("road");
  options.add_keep_roles("ground");
  options.add_keep_trajectories(1);
  options.add_polygon(1.);
  options.set_remove_transient(true);
  options.mutable_transient()->set_min_time_between_visits_s(30.);
  options.mutable_transient()->set_tolerance_m(0.4);
  options.mutable_transient()->set_min_ground_hits(2);
  options.mutable_transient()->set_max_movable_share(0.1);
  options.mutable_transient()->set_max_height_difference_m(3.);
  FilterReport report;
  report.trajectories = {3, 2, 6};
  EXPECT_EQ(HistoryLine(options, report, StreetLabels()),
            "filter --keep=road --keep_role=ground --polygon=1 --keep_trajectory=1 "
            "--remove_transient (min_time_between_visits_s = 30, tolerance_m = 0.4, "
            "min_ground_hits = 2, max_movable_share = 0.1, max_height_difference_m = 3): removed 3 "
            "nodes, 2 submaps, 6 constraints");
}

}  // namespace
}  // namespace cartographer::map
