// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/loaded_map.h"

#include <gtest/gtest.h>

#include "cartographer/io/map_writer.h"
#include "cartographer/map/renumber.h"
#include "cartographer/slam/graph_of_map.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::cli {
namespace {

namespace io = cartographer::io;
using cartographer::map::Map;
using cartographer::map::Renumbered;
using cartographer::slam::NextTrajectoryId;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;

// A map that numbers its trajectories up to `last`.
Map MapUpTo(int last) {
  Map map = SmallMap(4, 20);
  const int offset = last + 1 - NextTrajectoryId(map);
  return Renumbered(std::move(map), offset);
}

TEST(LoadedMapTest, WhatIsJoinedToItsTrajectoriesCanBeReadAgain) {
  const TemporaryDirectory directory;
  const std::string path = directory / "map.pbstream";
  ASSERT_TRUE(io::WriteMap(MapUpTo(399'999'999), path).ok());
  absl::StatusOr<Map> map = LoadMapFor(semantic_kiss_testing::StreetLabels(), path, {});
  ASSERT_TRUE(map.ok()) << map.status();
  // As a second one like it would be numbered.
  const int offset = NextTrajectoryId(*map);
  ASSERT_TRUE(io::WriteMap(Renumbered(*std::move(map), offset), path).ok());
  EXPECT_TRUE(io::ReadMap(path).ok());
}

TEST(LoadedMapTest, TrajectoriesWithoutNumbersForMoreAreRefused) {
  const TemporaryDirectory directory;
  const std::string path = directory / "map.pbstream";
  ASSERT_TRUE(io::WriteMap(MapUpTo(400'000'000), path).ok());
  EXPECT_EQ(LoadMapFor(semantic_kiss_testing::StreetLabels(), path, {}).status().message(),
            path +
                ": its trajectories are numbered beyond 399999999, so that nothing can be joined "
                "to them; is the file damaged?");
}

}  // namespace
}  // namespace semantic_kiss::cli
