// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/point_cloud_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "cartographer/io/map_writer.h"
#include "glog/logging.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;
using ::testing::HasSubstr;

class PointCloudFilesTest : public ::testing::Test {
 protected:
  // Two points, a car (id 10, colour 10 20 245) and a piece of road (id 40, colour 40 80 215).
  MapCloud TwoPoints(bool intensities) {
    map::Map map = SmallMap(1, 0);
    auto cloud = std::make_shared<sensor::LabeledPointCloud>();
    cloud->positions = {{1.f, -2.f, 0.5f}, {4.f, 0.25f, 0.f}};
    cloud->labels = {sensor::Label{2}, sensor::Label{1}};
    cloud->certainties = {1.f, 0.2f};
    if (intensities) cloud->intensities = {0.f, 1.f};
    const submap::NodeId id = map.nodes.begin()->first;
    map.nodes[id].cloud = cloud;
    map.nodes[id].map_from_node = map.nodes[id].local_from_node = transform::Rigid3d();
    CHECK(WriteMap(map, directory_ / "map").ok());
    auto result = MapCloud::Read(directory_ / "map", CloudSource::kNodes, {});
    CHECK(result.ok()) << result.status();
    CHECK_EQ(result->size(), 2u);
    return *std::move(result);
  }

  TemporaryDirectory directory_;
};

// The bytes of the values, one after the other.
template <typename... Values>
std::string Bytes(const Values&... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof(values)), ...);
  return bytes;
}

constexpr uint8_t Byte(int value) { return static_cast<uint8_t>(value); }

TEST_F(PointCloudFilesTest, GoldenPly) {
  ASSERT_TRUE(WritePly(TwoPoints(false), directory_ / "cloud.ply").ok());
  EXPECT_EQ(ReadText(directory_ / "cloud.ply"),
            "ply\n"
            "format binary_little_endian 1.0\n"
            "comment label 40 road\n"
            "comment label 10 car\n"
            "element vertex 2\n"
            "property float x\n"
            "property float y\n"
            "property float z\n"
            "property uchar red\n"
            "property uchar green\n"
            "property uchar blue\n"
            "property ushort label\n"
            "property float certainty\n"
            "end_header\n" +
                Bytes(1.f, -2.f, 0.5f, Byte(10), Byte(20), Byte(245), uint16_t{10}, 1.f) +
                Bytes(4.f, 0.25f, 0.f, Byte(40), Byte(80), Byte(215), uint16_t{40}, 51.f / 255.f));
}

TEST_F(PointCloudFilesTest, GoldenPcd) {
  ASSERT_TRUE(WritePcd(TwoPoints(false), directory_ / "cloud.pcd").ok());
  EXPECT_EQ(ReadText(directory_ / "cloud.pcd"),
            "# .PCD v0.7 - Point Cloud Data file format\n"
            "# label 40 road\n"
            "# label 10 car\n"
            "VERSION 0.7\n"
            "FIELDS x y z rgb label certainty\n"
            "SIZE 4 4 4 4 4 4\n"
            "TYPE F F F F U F\n"
            "COUNT 1 1 1 1 1 1\n"
            "WIDTH 2\n"
            "HEIGHT 1\n"
            "VIEWPOINT 0 0 0 1 0 0 0\n"
            "POINTS 2\n"
            "DATA binary\n" +
                Bytes(1.f, -2.f, 0.5f, uint32_t{0x0a14f5}, uint32_t{10}, 1.f) +
                Bytes(4.f, 0.25f, 0.f, uint32_t{0x2850d7}, uint32_t{40}, 51.f / 255.f));
}

TEST_F(PointCloudFilesTest, IntensitiesComeLast) {
  const MapCloud cloud = TwoPoints(true);
  ASSERT_TRUE(WritePly(cloud, directory_ / "cloud.ply").ok());
  const std::string ply = ReadText(directory_ / "cloud.ply");
  EXPECT_THAT(ply, HasSubstr("property float certainty\nproperty float intensity\nend_header\n"));
  EXPECT_EQ(ply.substr(ply.size() - 8), Bytes(51.f / 255.f, 1.f));
  ASSERT_TRUE(WritePcd(cloud, directory_ / "cloud.pcd").ok());
  const std::string pcd = ReadText(directory_ / "cloud.pcd");
  EXPECT_THAT(pcd, HasSubstr("FIELDS x y z rgb label certainty intensity\n"
                             "SIZE 4 4 4 4 4 4 4\nTYPE F F F F U F F\nCOUNT 1 1 1 1 1 1 1\n"));
  EXPECT_EQ(pcd.substr(pcd.size() - 8), Bytes(51.f / 255.f, 1.f));
}

TEST_F(PointCloudFilesTest, UnwritablePlacesAreNamed) {
  const absl::Status status = WritePly(TwoPoints(false), directory_ / "none/cloud.ply");
  EXPECT_THAT(std::string(status.message()), HasSubstr("none/cloud.ply"));
  std::filesystem::create_directory(directory_ / "cloud.pcd");
  EXPECT_THAT(std::string(WritePcd(TwoPoints(false), directory_ / "cloud.pcd").message()),
              HasSubstr("cloud.pcd"));
}

}  // namespace
}  // namespace cartographer::io
