// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cartographer/io/map_writer.h"
#include "glog/logging.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using ::testing::HasSubstr;

class MapTrajectoryTest : public ::testing::Test {
 protected:
  void Write(const map::Map& map) { CHECK(WriteMap(map, path_).ok()); }
  std::string Error(std::optional<int> id) {
    return std::string(ReadMapTrajectory(path_, id).status().message());
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_ / "map.pbstream";
};

TEST_F(MapTrajectoryTest, ReadsTheChosenOne) {
  const map::Map map = SmallMap(3, 2);
  Write(map);
  const auto trajectory = ReadMapTrajectory(path_, 4);
  ASSERT_TRUE(trajectory.ok()) << trajectory.status();
  ASSERT_EQ(trajectory->times.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const map::MapNode& node = map.nodes.at({4, 3 + i});
    EXPECT_EQ(trajectory->times[i], node.time);
    EXPECT_EQ(trajectory->map_from_sensor[i].Matrix(), node.map_from_node.Matrix());
  }
}

TEST_F(MapTrajectoryTest, TheOnlyOneNeedsNoName) {
  map::Map map = SmallMap(3, 2);
  map.nodes.erase(map.nodes.begin(), map.nodes.lower_bound({4, 0}));
  map.constraints.clear();
  Write(map);
  EXPECT_EQ(ReadMapTrajectory(path_, std::nullopt)->times.size(), 3u);
}

TEST_F(MapTrajectoryTest, ErrorsTellWhatThereIs) {
  Write(SmallMap(3, 2));
  EXPECT_EQ(Error(std::nullopt),
            path_ + ": the map has several trajectories: 1, 4; choose one of them");
  EXPECT_EQ(Error(2), path_ + ": the map has no trajectory 2 with nodes; it has 1, 4");
  Write(map::Map());
  EXPECT_EQ(Error(std::nullopt), path_ + ": the map has no nodes");
}

// Submaps and nodes come after all that is needed: even a file that ends before them will do.
TEST_F(MapTrajectoryTest, TheRestOfTheFileIsNotTouched) {
  Write(SmallMap(3, 200));
  const std::string bytes = ReadText(path_);
  WriteText(path_, bytes.substr(0, bytes.size() / 3));
  EXPECT_TRUE(ReadMapTrajectory(path_, 1).ok());
}

}  // namespace
}  // namespace cartographer::io
