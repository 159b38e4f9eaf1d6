// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/semantic_grid_proto.h"

#include <random>

namespace cartographer::io {
namespace {

using submap::CellIndex;
using submap::SemanticGrid;
using ::testing::HasSubstr;

SemanticGrid RandomGrid(int num_hits, int range) {
  std::mt19937 random(1);
  SemanticGrid grid(0.2);
  for (int i = 0; i < num_hits; ++i) {
    const CellIndex cell(static_cast<int>(random() % (2 * range)) - range,
                         static_cast<int>(random() % (2 * range)) - range);
    grid.AddHits(sensor::Label{static_cast<uint8_t>(random() % 3)}, cell,
                 1 + static_cast<int>(random() % 300));
  }
  return grid;
}

map::proto::SemanticGrid GoodProto() { return *ToProto(RandomGrid(100, 50), 3); }

std::string ErrorOf(const map::proto::SemanticGrid& proto) {
  return std::string(FromProto(proto, 3).status().message());
}

TEST(SemanticGridProtoTest, RoundTripIsLossFree) {
  for (const int range : {1, 20, 100000}) {
    const SemanticGrid grid = RandomGrid(1000, range);
    const auto proto = ToProto(grid, 3);
    ASSERT_TRUE(proto.ok());
    const auto back = FromProto(*proto, 3);
    ASSERT_TRUE(back.ok()) << back.status();
    ASSERT_EQ(back->num_tiles(), grid.num_tiles());
    ASSERT_EQ(back->Labels(), grid.Labels());
    for (const sensor::Label label : grid.Labels()) {
      const SemanticGrid::Layer layer = back->LayerOf(label);
      for (const auto& [index, tile] : grid.LayerOf(label)) {
        ASSERT_EQ(layer.count(index), 1u);
        EXPECT_EQ(layer.at(index)->hits, tile->hits);
      }
    }
    EXPECT_EQ(ToProto(*back, 3)->SerializeAsString(), proto->SerializeAsString());
  }
}

TEST(SemanticGridProtoTest, ExtremesSurvive) {
  SemanticGrid grid(0.1);
  grid.AddHits(sensor::kUnlabeled, {0, 0}, 1 << 30);  // saturates
  grid.SetTile(sensor::Label{2}, {-7, 3}, SemanticGrid::Tile());
  const auto back = FromProto(*ToProto(grid, 3), 3);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->Hits(sensor::kUnlabeled, {0, 0}), SemanticGrid::kMaxHits);
  EXPECT_EQ(back->LayerOf(sensor::Label{2}).size(), 1u);
  EXPECT_EQ(FromProto(*ToProto(SemanticGrid(0.5), 1), 1)->num_tiles(), 0u);
}

TEST(SemanticGridProtoTest, WhatDoesNotFitIsNotWritten) {
  SemanticGrid grid(0.1);
  grid.AddHits(sensor::Label{3}, {0, 0});
  EXPECT_THAT(std::string(ToProto(grid, 3).status().message()),
              HasSubstr("layer of label 3: not in the label set of 3"));
  SemanticGrid far(0.1);
  far.AddHits(sensor::Label{1}, {1 << 30, (1 << 30) + 100});
  EXPECT_THAT(std::string(ToProto(far, 3).status().message()), HasSubstr("too far"));
  EXPECT_THAT(std::string(ToProto(SemanticGrid(1e-4), 3).status().message()),
              HasSubstr("outside [0.001, 1000]"));
}

TEST(SemanticGridProtoTest, NonsenseIsAnError) {
  map::proto::SemanticGrid proto = GoodProto();
  EXPECT_EQ(ErrorOf(proto), "");
  for (const double resolution : {0., -0.1, 1e6, std::nan("")}) {
    proto.set_resolution_m(resolution);
    EXPECT_THAT(ErrorOf(proto), HasSubstr("a grid with cells of"));
  }
  proto = GoodProto();
  proto.mutable_layers(2)->set_label(3);
  EXPECT_THAT(ErrorOf(proto), HasSubstr("layer of label 3: not in the label set of 3"));
  proto.mutable_layers(2)->set_label(1);
  EXPECT_THAT(ErrorOf(proto), HasSubstr("layer of label 1: out of order"));

  proto = GoodProto();
  proto.mutable_layers(1)->add_tile_x_deltas(1);
  EXPECT_THAT(ErrorOf(proto), HasSubstr("layer of label 1: "));
  proto = GoodProto();
  proto.mutable_layers(1)->mutable_hit_cells()->pop_back();
  EXPECT_THAT(ErrorOf(proto), HasSubstr("bytes of hit cells"));

  proto = GoodProto();
  proto.mutable_layers(0)->set_tile_y_deltas(1, -1);
  EXPECT_THAT(ErrorOf(proto), HasSubstr("layer of label 0: tile 1 is out of order"));
  proto.mutable_layers(0)->set_tile_y_deltas(1, 1 << 28);
  EXPECT_THAT(ErrorOf(proto), HasSubstr("tile 1 is out of range"));
}

TEST(SemanticGridProtoTest, CountsOfHitsAreChecked) {
  const auto with_hits = [](const std::string& hits) {
    SemanticGrid grid(1.);
    grid.AddHits(sensor::Label{1}, {0, 0});
    map::proto::SemanticGrid proto = *ToProto(grid, 3);
    proto.mutable_layers(0)->set_hits(hits);
    return proto;
  };
  EXPECT_EQ(ErrorOf(with_hits("\xff\xff\x03")), "");  // 65535
  for (const std::string& bad : {std::string(), std::string(1, '\0'), std::string("\xff"),
                                 std::string("\x80\x80\x04"), std::string("\xff\xff\xff\x01")}) {
    EXPECT_THAT(ErrorOf(with_hits(bad)), HasSubstr("tile 0 has invalid counts of hits"));
  }
  EXPECT_THAT(ErrorOf(with_hits("\x01\x01")), HasSubstr("more counts of hits than hit cells"));
}

// A file of kilobytes must not be able to ask for gigabytes of tiles.
TEST(SemanticGridProtoTest, TheNumberOfTilesIsLimited) {
  map::proto::SemanticGrid proto;
  proto.set_resolution_m(1.);
  map::proto::SemanticLayer& layer = *proto.add_layers();
  constexpr int kTooMany = (1 << 19) + 1;
  for (int i = 0; i < kTooMany; ++i) {
    layer.add_tile_x_deltas(1);
    layer.add_tile_y_deltas(0);
  }
  layer.mutable_hit_cells()->resize(32 * size_t{kTooMany}, '\0');
  EXPECT_THAT(ErrorOf(proto), HasSubstr("more than 524288 tiles"));
}

}  // namespace
}  // namespace cartographer::io
