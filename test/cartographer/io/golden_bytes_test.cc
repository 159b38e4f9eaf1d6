// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <vector>

#include "cartographer/io/map_writer.h"
#include "glog/logging.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

// Takes a file apart by hand, without our reader and without protobuf: what stands here is what
// docs/file_formats.md promises to other programs.
namespace cartographer::io {
namespace {

using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::StreetLabels;
using semantic_kiss_testing::TemporaryDirectory;
using ::testing::ElementsAre;

uint64_t LittleEndian(const std::string& bytes, size_t offset) {
  uint64_t value = 0;
  for (int i = 0; i < 8; ++i)
    value |= uint64_t{static_cast<uint8_t>(bytes.at(offset + i))} << 8 * i;
  return value;
}

std::string Gunzip(const std::string& member) {
  z_stream stream = {};
  EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(member.data()));
  stream.avail_in = static_cast<uInt>(member.size());
  std::string data(1 << 24, '\0');
  stream.next_out = reinterpret_cast<Bytef*>(data.data());
  stream.avail_out = static_cast<uInt>(data.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(stream.avail_in, 0u);
  data.resize(stream.total_out);
  inflateEnd(&stream);
  return data;
}

std::vector<std::string> Records(const std::string& bytes) {
  std::vector<std::string> records;
  size_t offset = 8;
  while (offset < bytes.size()) {
    const uint64_t size = LittleEndian(bytes, offset);
    records.push_back(Gunzip(bytes.substr(offset + 8, size)));
    offset += 8 + size;
  }
  EXPECT_EQ(offset, bytes.size());
  return records;
}

uint64_t TakeVarint(const std::string& bytes, size_t* offset) {
  uint64_t value = 0;
  for (int shift = 0;; shift += 7) {
    const auto byte = static_cast<uint8_t>(bytes.at((*offset)++));
    value |= uint64_t{byte & 0x7fu} << shift;
    if (byte < 0x80) return value;
  }
}

std::vector<int64_t> Varints(const std::string& bytes) {
  std::vector<int64_t> values;
  for (size_t offset = 0; offset < bytes.size();) {
    values.push_back(static_cast<int64_t>(TakeVarint(bytes, &offset)));
  }
  return values;
}

int64_t ZigZag(int64_t value) {
  return static_cast<int64_t>(static_cast<uint64_t>(value) >> 1) ^ -(value & 1);
}

double AsDouble(uint64_t bits) {
  double value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

float AsFloat(uint64_t bits) {
  const auto low = static_cast<uint32_t>(bits);
  float value;
  std::memcpy(&value, &low, sizeof(value));
  return value;
}

// The fields of a message: numbers as they are on the wire, all else as bytes.
struct Wire {
  explicit Wire(const std::string& bytes) {
    for (size_t offset = 0; offset < bytes.size();) {
      const uint64_t tag = TakeVarint(bytes, &offset);
      const int field = static_cast<int>(tag >> 3);
      const size_t size = (tag & 7) == 2 ? TakeVarint(bytes, &offset) : (tag & 7) == 5 ? 4 : 8;
      if ((tag & 7) == 0) {
        numbers[field] = TakeVarint(bytes, &offset);
        continue;
      }
      const std::string value = bytes.substr(offset, size);
      EXPECT_EQ(value.size(), size);
      offset += size;
      if ((tag & 7) == 2) {
        messages[field].push_back(value);
      } else {
        numbers[field] = LittleEndian(value + std::string(4, '\0'), 0);
      }
    }
  }
  Wire operator[](int field) const { return Wire(Bytes(field)); }
  std::string Bytes(int field) const {
    return messages.count(field) > 0 ? messages.at(field).front() : "";
  }
  size_t Count(int field) const {
    return messages.count(field) > 0 ? messages.at(field).size() : 0;
  }
  uint64_t Number(int field) const { return numbers.count(field) > 0 ? numbers.at(field) : 0; }
  double Double(int field) const { return AsDouble(Number(field)); }

  std::map<int, std::vector<std::string>> messages;
  std::map<int, uint64_t> numbers;
};

// One submap of 1 m cells at (10, 20, 3) in the local frame: road hit 1 and 100 times in the cells
// (0, 0) and (1, 0), a building 3 times in (-1, 1). One node with two points.
map::Map TinyMap() {
  map::Map map;
  map.labels = StreetLabels();
  map.configuration_lua = "return {}";
  map.history = {"made by hand"};
  auto submap = std::make_shared<submap::Submap>(1.);
  submap->local_from_submap = transform::Rigid3d::Translation({10., 20., 3.});
  submap->num_scans = 7;
  submap->finished = true;
  submap->grid.AddHits(sensor::Label{1}, {0, 0}, 1);
  submap->grid.AddHits(sensor::Label{1}, {1, 0}, 100);
  submap->grid.AddHits(sensor::Label{3}, {-1, 1}, 300);
  submap->cloud.positions = {{0.001f, 0.f, 0.f}};
  submap->cloud.labels = {sensor::Label{3}};
  submap->cloud.certainties = {0.2f};
  map.submaps[{0, 0}] = {transform::Rigid3d::Translation({11., 21., 4.}), submap};
  auto cloud = std::make_shared<sensor::LabeledPointCloud>();
  cloud->positions = {{1.024f, 0.002f, -0.003f}, {0.f, 0.f, 0.f}};
  cloud->labels = {sensor::Label{1}, sensor::Label{4}};
  cloud->certainties = {1.f, 0.f};
  map.nodes[{0, 5}] = {common::FromUniversal(123456789),
                       transform::Rigid3d::Translation({1., 2., 3.}),
                       transform::Rigid3d::Translation({4., 5., 6.}), cloud};
  map.constraints.push_back({{0, 0},
                             {0, 5},
                             transform::Rigid3d::Translation({7., 8., 9.}),
                             10.,
                             20.,
                             map::Constraint::Kind::kInterSubmap});
  map::Constraint own;
  own.node_id = {0, 5};
  map.constraints.push_back(own);
  map::Constraint loop = own;
  loop.kind = map::Constraint::Kind::kInterSubmap;
  loop.information = Eigen::Matrix<double, 6, 6>::Identity() * 400.;
  map.constraints.push_back(loop);
  return map;
}

class GoldenBytesTest : public ::testing::Test {
 protected:
  GoldenBytesTest() {
    const std::string path = directory_ / "map.pbstream";
    CHECK(WriteMap(TinyMap(), path).ok());
    bytes_ = ReadText(path);
    records_ = Records(bytes_);
    CHECK_EQ(records_.size(), 5u);
  }

  TemporaryDirectory directory_;
  std::string bytes_;
  std::vector<std::string> records_;
};

TEST_F(GoldenBytesTest, MagicAndGzipHeaders) {
  EXPECT_EQ(bytes_.substr(0, 8), "\xdb\x01\xf5\x5b\x7b\x1f\x1d\x7b");
  // Deflate, no flags, no time, "unknown" system.
  EXPECT_EQ(bytes_.substr(16, 10), std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10));
}

TEST_F(GoldenBytesTest, Header) {
  const Wire header(records_[0]);
  EXPECT_EQ(records_[0].substr(0, 2), "\x08\x02");  // format_version = 2
  EXPECT_EQ(header[1000][1].Bytes(1), "street");
  EXPECT_EQ(header[1000][1].Count(3), 5u);
  EXPECT_EQ(header[1000].Bytes(2), "return {}");
  EXPECT_EQ(header[1000].Bytes(3), "made by hand");
}

TEST_F(GoldenBytesTest, PoseGraph) {
  const Wire graph = Wire(records_[1])[1];
  const Wire constraint = graph[2];
  EXPECT_EQ(constraint[2].Number(2), 5u);
  EXPECT_EQ(constraint[3][1].Double(1), 7.);
  EXPECT_EQ(constraint[3][2].Double(4), 1.);
  EXPECT_EQ(constraint.Double(6), 10.);
  EXPECT_EQ(constraint.Double(7), 20.);
  EXPECT_EQ(constraint.Number(5), 1u);  // INTER_SUBMAP
  const Wire trajectory = graph[4];
  EXPECT_EQ(trajectory[1].Number(7), 5u);
  EXPECT_EQ(trajectory[1].Number(1), 123456789u);
  EXPECT_EQ(trajectory[1][5][1].Double(3), 3.);
  EXPECT_EQ(trajectory[2][1][1].Double(1), 11.);
}

// With these weights, which are those of its own constraints, Cartographer's optimization leaves
// our maps as they are; with smaller ones it would open the loops again.
TEST_F(GoldenBytesTest, WeightsThatCartographerCanOptimizeWith) {
  const std::vector<std::string> constraints = Wire(records_[1])[1].messages.at(2);
  ASSERT_EQ(constraints.size(), 3u);
  const Wire own(constraints[1]), loop(constraints[2]);
  EXPECT_EQ(own.Number(5), 0u);  // INTRA_SUBMAP
  EXPECT_EQ(own.Double(6), 5e2);
  EXPECT_EQ(own.Double(7), 1.6e3);
  EXPECT_EQ(own.Count(1000), 0u);
  EXPECT_EQ(loop.Number(5), 1u);
  EXPECT_EQ(loop.Double(6), 1.1e4);
  EXPECT_EQ(loop.Double(7), 1e5);
  EXPECT_EQ(loop.Bytes(1000).size(), 21 * sizeof(double));
}

TEST_F(GoldenBytesTest, OneEntryOfOptionsForTheTrajectory) {
  EXPECT_EQ(Wire(records_[2])[2].Count(1), 1u);
  EXPECT_EQ(Wire(records_[2])[2][1][1].Bytes(2), "lidar");
}

TEST_F(GoldenBytesTest, StockPartOfTheSubmap) {
  const Wire submap = Wire(records_[3])[3][2];
  EXPECT_EQ(submap[1][1].Double(2), 20.);
  EXPECT_EQ(submap.Number(2), 7u);
  EXPECT_EQ(submap.Number(3), 1u);
  // Cells -1..1 by 0..1 of the submap: x from 9 to 12 m, y from 20 to 22 m in the local frame.
  const Wire limits = submap[4][1];
  EXPECT_EQ(limits.Double(1), 1.);
  EXPECT_EQ(limits[2].Double(1), 12.);
  EXPECT_EQ(limits[2].Double(2), 22.);
  EXPECT_EQ(limits[3].Number(1), 2u);  // along -y
  EXPECT_EQ(limits[3].Number(2), 3u);  // along -x
  // Rows x = 1, 0, -1 with y = 1, 0 each. Free for sure; rather free, P = 1 / (1 + 11/9) = 0.45:
  // 1 + 0.45 / 0.8 * 32766; occupied for sure.
  EXPECT_THAT(Varints(submap[4].Bytes(2)), ElementsAre(0, 32767, 0, 18432, 1, 0));
  EXPECT_EQ(submap[4][3].Number(1), 1u);  // max_x
  EXPECT_EQ(submap[4][3].Number(2), 2u);  // max_y
  EXPECT_EQ(submap[4][3].Number(3), 0u);  // min_x
  EXPECT_EQ(submap[4][3].Number(4), 0u);  // min_y
  EXPECT_EQ(submap[4].Count(4), 1u);      // probability_grid_2d
  EXPECT_EQ(AsFloat(submap[4].Number(6)), 0.1f);
  EXPECT_EQ(AsFloat(submap[4].Number(7)), 0.9f);
}

TEST_F(GoldenBytesTest, LayersOfTheSubmap) {
  const Wire semantic = Wire(records_[3])[3][1000];
  EXPECT_EQ(semantic[1].Double(1), 1.);
  ASSERT_EQ(semantic[1].Count(2), 2u);
  const Wire road(semantic[1].messages.at(2)[0]), building(semantic[1].messages.at(2)[1]);
  EXPECT_EQ(road.Number(1), 1u);
  EXPECT_THAT(Varints(road.Bytes(2)), ElementsAre(0));
  EXPECT_EQ(road.Bytes(4), "\x03" + std::string(31, '\0'));
  EXPECT_THAT(Varints(road.Bytes(5)), ElementsAre(1, 100));
  EXPECT_EQ(building.Number(1), 3u);
  EXPECT_EQ(ZigZag(Varints(building.Bytes(2))[0]), -1);
  EXPECT_THAT(Varints(building.Bytes(3)), ElementsAre(0));
  // Cell (15, 1) of tile (-1, 0).
  EXPECT_EQ(building.Bytes(4), std::string(3, '\0') + "\x80" + std::string(28, '\0'));
  EXPECT_THAT(Varints(building.Bytes(5)), ElementsAre(300));
  EXPECT_THAT(Varints(semantic[2].Bytes(3)), ElementsAre(1, 0, 0, 0, 1));
  EXPECT_EQ(semantic[3].Bytes(1), "\x03");
  EXPECT_EQ(semantic[3].Bytes(2), "\x33");
}

TEST_F(GoldenBytesTest, Node) {
  const Wire node = Wire(records_[4])[4];
  EXPECT_EQ(node[1].Number(2), 5u);
  EXPECT_EQ(node[5].Number(1), 123456789u);
  EXPECT_EQ(node[5][2].Double(4), 1.);  // level already
  EXPECT_EQ(node[5][7][1].Double(1), 4.);
  EXPECT_EQ(node[5][3].Number(1), 2u);
  // Two blocks of one point each: (1, 0, -1) comes first, for its lower z.
  EXPECT_THAT(Varints(node[5][3].Bytes(3)),
              ElementsAre(1, 1, 0, -1, (1021 << 20) + (2 << 10), 1, 0, 0, 0, 0));
  EXPECT_EQ(node[1000].Bytes(1), "\x01\x04");
  EXPECT_EQ(node[1000].Bytes(2), std::string("\xff\0", 2));
}

}  // namespace
}  // namespace cartographer::io
