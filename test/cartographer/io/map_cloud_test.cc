// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_writer.h"
#include "glog/logging.h"
#include "test/cartographer/io/memory_peak.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;
using ::testing::HasSubstr;

class MapCloudTest : public ::testing::Test {
 protected:
  void Write(const map::Map& map) {
    const absl::Status status = WriteMap(map, path_);
    CHECK(status.ok()) << status;
  }

  MapCloud Read(CloudSource source, const proto::RenderOptions& options = {}) {
    auto cloud = MapCloud::Read(path_, source, options);
    CHECK(cloud.ok()) << cloud.status();
    return *std::move(cloud);
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_ / "map.pbstream";
};

TEST_F(MapCloudTest, HoldsEveryPointWhereItIsInTheMap) {
  Write(SmallMap(4, 50));
  const map::Map map = *ReadMap(path_);
  const MapCloud nodes = Read(CloudSource::kNodes), submaps = Read(CloudSource::kSubmaps);
  size_t i = 0;
  for (const auto& [id, node] : map.nodes) {
    for (size_t j = 0; j < node.cloud->size(); ++j, ++i) {
      const Eigen::Vector3d expected = node.map_from_node * node.cloud->positions[j].cast<double>();
      EXPECT_EQ(nodes.At(i).position, expected.cast<float>());
      EXPECT_EQ(nodes.At(i).label, node.cloud->labels[j]);
      EXPECT_EQ(nodes.At(i).certainty, node.cloud->certainties[j]);
    }
  }
  EXPECT_EQ(nodes.size(), i);
  i = 0;
  for (const auto& [id, placed] : map.submaps) {
    for (const Eigen::Vector3f& position : placed.submap->cloud.positions) {
      const Eigen::Vector3d expected = placed.map_from_submap * position.cast<double>();
      EXPECT_EQ(submaps.At(i++).position, expected.cast<float>());
    }
  }
  EXPECT_EQ(submaps.size(), i);
}

TEST_F(MapCloudTest, IntensitiesCountOnlyIfAllPointsHaveThem) {
  map::Map map = SmallMap(2, 20);  // trajectory 4 has some, 1 has none
  Write(map);
  EXPECT_FALSE(Read(CloudSource::kNodes).has_intensities());
  EXPECT_FALSE(Read(CloudSource::kSubmaps).has_intensities());
  map.nodes.erase(map.nodes.begin(), map.nodes.lower_bound({4, 0}));
  map.constraints.clear();
  Write(map);
  const MapCloud cloud = Read(CloudSource::kNodes);
  EXPECT_TRUE(cloud.has_intensities());
  EXPECT_EQ(cloud.At(0).intensity, ReadMap(path_)->nodes.begin()->second.cloud->intensities[0]);
}

TEST_F(MapCloudTest, HiddenLabelsAreLeftOut) {
  Write(SmallMap(2, 50));
  proto::RenderOptions options;
  options.add_show("car");
  const MapCloud cars = Read(CloudSource::kSubmaps, options);
  for (size_t i = 0; i < cars.size(); ++i) EXPECT_EQ(cars.At(i).label, sensor::Label{2});
  options.clear_show();
  options.add_hide("car");
  EXPECT_EQ(Read(CloudSource::kSubmaps, options).size() + cars.size(),
            Read(CloudSource::kSubmaps).size());
  options.add_hide("cra");
  EXPECT_THAT(std::string(MapCloud::Read(path_, CloudSource::kNodes, options).status().message()),
              HasSubstr("hide: "));
}

TEST_F(MapCloudTest, ThinningLeavesOnePointACube) {
  Write(SmallMap(4, 200, 3.f));
  proto::RenderOptions options;
  options.set_cloud_resolution_m(1.);
  const MapCloud thinned = Read(CloudSource::kSubmaps, options);
  EXPECT_LT(thinned.size(), Read(CloudSource::kSubmaps).size() / 2);
  std::set<std::tuple<int, int, int>> cubes;
  for (size_t i = 0; i < thinned.size(); ++i) {
    const Eigen::Array3i cube = thinned.At(i).position.array().floor().cast<int>();
    EXPECT_TRUE(cubes.emplace(cube.x(), cube.y(), cube.z()).second) << "two points in a cube";
  }
  options.set_cloud_resolution_m(1e-6);
  EXPECT_THAT(std::string(MapCloud::Read(path_, CloudSource::kNodes, options).status().message()),
              HasSubstr("is too far away for cubes of 1e-06 m"));
}

TEST_F(MapCloudTest, NothingToWriteIsAnError) {
  Write(map::Map());
  EXPECT_THAT(std::string(MapCloud::Read(path_, CloudSource::kNodes, {}).status().message()),
              HasSubstr("no points to write: no cloud of a node"));
  Write(SmallMap(2, 0));
  EXPECT_THAT(std::string(MapCloud::Read(path_, CloudSource::kSubmaps, {}).status().message()),
              HasSubstr("no points to write: no cloud of a submap"));
  EXPECT_TRUE(
      absl::IsNotFound(MapCloud::Read(directory_ / "none", CloudSource::kSubmaps, {}).status()));
}

// A thinned cloud needs the memory of what comes out and of a few records.
TEST_F(MapCloudTest, MemoryDoesNotGrowWithTheMap) {
  proto::RenderOptions options;
  options.set_cloud_resolution_m(50.);
  const auto peak = [&](int nodes) {
    Write(SmallMap(nodes, 300));
    const MemoryPeak memory;
    Read(CloudSource::kSubmaps, options);
    return memory.bytes();
  };
  EXPECT_LT(peak(200), 2 * peak(50));
}

}  // namespace
}  // namespace cartographer::io
