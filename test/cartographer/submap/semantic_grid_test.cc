// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/semantic_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

namespace cartographer::submap {
namespace {

using sensor::kUnlabeled;
using sensor::Label;
using sensor::LabelMask;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Label kRoad{1}, kCar{2}, kPole{3};
constexpr Label kLast{255};

LabelMask MaskOf(std::initializer_list<Label> labels) {
  LabelMask mask;
  for (const Label label : labels) mask.Insert(label);
  return mask;
}

TEST(SemanticGridTest, StartsEmpty) {
  const SemanticGrid grid(0.2);
  EXPECT_DOUBLE_EQ(grid.resolution_m(), 0.2);
  EXPECT_EQ(grid.Hits(kRoad, {0, 0}), 0);
  EXPECT_EQ(grid.Dominant({0, 0}).hits, 0);
  EXPECT_EQ(grid.Dominant({0, 0}).label, kUnlabeled);
  EXPECT_THAT(grid.Labels(), IsEmpty());
  EXPECT_THAT(grid.LayerOf(kRoad), IsEmpty());
  EXPECT_THAT(grid.DominantTiles(), IsEmpty());
  EXPECT_TRUE(grid.Bounds().Empty());
  EXPECT_EQ(grid.num_tiles(), 0);
}

TEST(SemanticGridDeathTest, RejectsResolutionsThatAreNotPositive) {
  EXPECT_DEATH(SemanticGrid(0.), "resolution_m");
  EXPECT_DEATH(SemanticGrid(-1.), "resolution_m");
}

TEST(SemanticGridTest, CellsAreHalfOpenBoxesOnBothSidesOfTheOrigin) {
  const SemanticGrid grid(0.5);
  const auto cell = [&](float x, float y) {
    const CellIndex index = grid.CellOf({x, y});
    return std::make_pair(index.x(), index.y());
  };
  EXPECT_EQ(cell(0.f, 0.f), std::make_pair(0, 0));
  EXPECT_EQ(cell(0.49f, 0.5f), std::make_pair(0, 1));
  EXPECT_EQ(cell(-0.01f, -0.5f), std::make_pair(-1, -1));
  EXPECT_EQ(cell(-0.51f, -8.f), std::make_pair(-2, -16));
}

TEST(SemanticGridTest, CentersLieInTheirCells) {
  const SemanticGrid grid(0.2);
  EXPECT_NEAR(grid.CenterOf({0, 0}).x(), 0.1, 1e-12);
  EXPECT_NEAR(grid.CenterOf({-1, 4}).x(), -0.1, 1e-12);
  EXPECT_NEAR(grid.CenterOf({-1, 4}).y(), 0.9, 1e-12);
  for (int i = -1000; i <= 1000; ++i) {
    const CellIndex cell(i, -3 * i + 7);
    const CellIndex found = grid.CellOf(grid.CenterOf(cell).cast<float>());
    EXPECT_TRUE((found == cell).all()) << found.transpose() << " for " << cell.transpose();
  }
}

TEST(SemanticGridTest, LayersDoNotMix) {
  SemanticGrid grid(0.2);
  grid.AddHits(kRoad, {3, 4});
  grid.AddHits(kRoad, {3, 4}, 5);
  grid.AddHits(kCar, {3, 4}, 2);
  EXPECT_EQ(grid.Hits(kRoad, {3, 4}), 6);
  EXPECT_EQ(grid.Hits(kCar, {3, 4}), 2);
  EXPECT_EQ(grid.Hits(kPole, {3, 4}), 0);
  EXPECT_EQ(grid.Hits(kRoad, {4, 3}), 0);
  EXPECT_THAT(grid.Labels(), ElementsAre(kRoad, kCar));
}

TEST(SemanticGridTest, NegativeCellsDoNotFallTogetherWithPositiveOnes) {
  SemanticGrid grid(0.2);
  const int far = 16 * ((1 << 27) - 1);  // the outermost tiles that keys can tell apart
  const std::vector<CellIndex> cells{{0, 0},   {-1, 0},   {0, -1},     {-1, -1},   {15, 15},
                                     {16, 16}, {-16, -1}, {-17, -17},  {far, far}, {-far, far},
                                     {far, 0}, {0, -far}, {-far, -far}};
  for (int i = 0; i < cells.size(); ++i) grid.AddHits(kLast, cells[i], i + 1);
  for (int i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(grid.Hits(kLast, cells[i]), i + 1) << cells[i].transpose();
  }
}

TEST(SemanticGridTest, CountsSaturate) {
  SemanticGrid grid(0.2);
  grid.AddHits(kRoad, {0, 0}, SemanticGrid::kMaxHits - 1);
  EXPECT_EQ(grid.Hits(kRoad, {0, 0}), 65534);
  grid.AddHits(kRoad, {0, 0});
  EXPECT_EQ(grid.Hits(kRoad, {0, 0}), 65535);
  grid.AddHits(kRoad, {0, 0});
  EXPECT_EQ(grid.Hits(kRoad, {0, 0}), 65535);
  grid.AddHits(kCar, {0, 0}, std::numeric_limits<int>::max());
  grid.AddHits(kCar, {0, 0}, std::numeric_limits<int>::max());
  EXPECT_EQ(grid.Hits(kCar, {0, 0}), 65535);
}

TEST(SemanticGridTest, TheSmallerLabelWinsTies) {
  SemanticGrid grid(0.2);
  grid.AddHits(kPole, {0, 0}, 3);
  grid.AddHits(kCar, {0, 0}, 3);
  EXPECT_EQ(grid.Dominant({0, 0}).label, kCar);
  EXPECT_EQ(grid.Dominant({0, 0}).hits, 3);
  grid.AddHits(kPole, {0, 0});
  EXPECT_EQ(grid.Dominant({0, 0}).label, kPole);
}

TEST(SemanticGridTest, UnlabeledYieldsToAnyOtherLabel) {
  SemanticGrid grid(0.2);
  grid.AddHits(kUnlabeled, {0, 0}, 100);
  EXPECT_EQ(grid.Dominant({0, 0}).label, kUnlabeled);
  EXPECT_EQ(grid.Dominant({0, 0}).hits, 100);
  grid.AddHits(kPole, {0, 0}, 1);
  EXPECT_EQ(grid.Dominant({0, 0}).label, kPole);
  EXPECT_EQ(grid.Dominant({0, 0}).hits, 1);
}

TEST(SemanticGridTest, LayersListTilesByRows) {
  SemanticGrid grid(0.2);
  grid.AddHits(kRoad, {0, 20});
  grid.AddHits(kRoad, {40, -1});
  grid.AddHits(kRoad, {-1, -1});
  grid.AddHits(kCar, {100, 100});
  std::vector<std::pair<int, int>> order;
  for (const auto& [index, tile] : grid.LayerOf(kRoad)) order.emplace_back(index.x, index.y);
  EXPECT_THAT(order,
              ElementsAre(std::make_pair(-1, -1), std::make_pair(2, -1), std::make_pair(0, 1)));
  // Cell (-1, -1) is the last of tile (-1, -1).
  EXPECT_EQ(grid.LayerOf(kRoad).at({-1, -1})->hits.back(), 1);
}

TEST(SemanticGridTest, SetTileReplacesTheWholeTile) {
  SemanticGrid grid(0.2);
  grid.AddHits(kRoad, {-5, 17}, 9);
  SemanticGrid::Tile tile;
  tile.hits[2 * SemanticGrid::kTileSize + 3] = 7;
  grid.SetTile(kRoad, {-1, 1}, tile);
  EXPECT_EQ(grid.Hits(kRoad, {-5, 17}), 0);
  EXPECT_EQ(grid.Hits(kRoad, {-13, 18}), 7);
  EXPECT_EQ(grid.num_tiles(), 1);
}

TEST(SemanticGridTest, RemovedLayersUncoverWhatLiesBeneath) {
  SemanticGrid grid(0.2);
  grid.AddHits(kCar, {0, 0}, 9);
  grid.AddHits(kRoad, {0, 0}, 2);
  grid.AddHits(kPole, {50, 50}, 4);
  grid.RemoveLayers(MaskOf({kCar}));
  EXPECT_EQ(grid.Dominant({0, 0}).label, kRoad);
  EXPECT_EQ(grid.Hits(kCar, {0, 0}), 0);
  EXPECT_EQ(grid.Hits(kPole, {50, 50}), 4);
  EXPECT_THAT(grid.Labels(), ElementsAre(kRoad, kPole));
  grid.AddHits(kCar, {0, 0}, 1);
  EXPECT_EQ(grid.Hits(kCar, {0, 0}), 1);
  grid.RemoveLayers(MaskOf({kCar, kRoad, kPole}));
  EXPECT_THAT(grid.Labels(), IsEmpty());
  EXPECT_TRUE(grid.Bounds().Empty());
}

TEST(SemanticGridTest, BoundsFollowTiles) {
  SemanticGrid grid(0.2);
  grid.AddHits(kRoad, {5, -5});
  const SemanticGrid::CellBox one = grid.Bounds();
  EXPECT_TRUE((one.min == CellIndex(0, -16)).all()) << one.min.transpose();
  EXPECT_TRUE((one.max == CellIndex(16, 0)).all()) << one.max.transpose();
  EXPECT_FALSE(one.Empty());
  grid.AddHits(kCar, {-33, 160});
  const SemanticGrid::CellBox two = grid.Bounds();
  EXPECT_TRUE((two.min == CellIndex(-48, -16)).all()) << two.min.transpose();
  EXPECT_TRUE((two.max == CellIndex(16, 176)).all()) << two.max.transpose();
  grid.RemoveLayers(MaskOf({kCar}));
  EXPECT_TRUE((grid.Bounds().min == one.min).all());
}

TEST(SemanticGridTest, CloudsAreProjectedAlongTheHeight) {
  SemanticGrid grid(0.5);
  sensor::LabeledPointCloud cloud;
  for (const float z : {-100.f, 0.f, 3.f}) {
    cloud.positions.emplace_back(1.1f, 0.1f, z);
    cloud.labels.push_back(kRoad);
    cloud.certainties.push_back(1.f);
  }
  cloud.positions.emplace_back(1.1f, 0.1f, 0.f);
  cloud.labels.push_back(kCar);
  cloud.certainties.push_back(1.f);
  // A quarter turn to the left, then a step along x.
  const transform::Rigid3d pose(
      Eigen::Vector3d(-2., 0., 5.),
      Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2., Eigen::Vector3d::UnitZ())));
  grid.AddCloud(cloud, pose, MaskOf({kCar}));
  EXPECT_EQ(grid.Hits(kRoad, {-5, 2}), 3);
  EXPECT_THAT(grid.Labels(), ElementsAre(kRoad));
}

// What the grid claims to be: a dense array of counters by label and cell.
class DenseGrid {
 public:
  void AddHits(Label label, const CellIndex& cell, int hits) {
    int& count = counts_[{cell.y(), cell.x(), label}];
    count = std::min(count + hits, SemanticGrid::kMaxHits);
  }
  void Remove(Label label) {
    for (auto it = counts_.begin(); it != counts_.end();) {
      it = std::get<2>(it->first) == label ? counts_.erase(it) : std::next(it);
    }
  }
  int Hits(Label label, const CellIndex& cell) const {
    const auto it = counts_.find({cell.y(), cell.x(), label});
    return it == counts_.end() ? 0 : it->second;
  }
  SemanticGrid::DominantLabel Dominant(const CellIndex& cell) const {
    SemanticGrid::DominantLabel best{kUnlabeled, 0};
    for (int i = 1; i < 256; ++i) {
      const Label label{static_cast<uint8_t>(i)};
      if (Hits(label, cell) > best.hits) best = {label, Hits(label, cell)};
    }
    if (best.hits == 0) best.hits = Hits(kUnlabeled, cell);
    return best;
  }

 private:
  std::map<std::tuple<int, int, Label>, int> counts_;
};

constexpr int kReach = 40;

void ExpectEqual(const SemanticGrid& grid, const DenseGrid& dense,
                 const std::vector<Label>& labels) {
  const auto tiles = grid.DominantTiles();
  for (int y = -kReach; y < kReach; ++y) {
    for (int x = -kReach; x < kReach; ++x) {
      const CellIndex cell(x, y);
      for (const Label label : labels) {
        ASSERT_EQ(grid.Hits(label, cell), dense.Hits(label, cell)) << x << " " << y;
      }
      const auto expected = dense.Dominant(cell);
      ASSERT_EQ(grid.Dominant(cell).label, expected.label) << x << " " << y;
      ASSERT_EQ(grid.Dominant(cell).hits, expected.hits) << x << " " << y;
      const auto it = tiles.find({x >> 4, y >> 4});
      if (it == tiles.end()) {
        ASSERT_EQ(expected.hits, 0) << x << " " << y;
        continue;
      }
      const int in_tile = (y & 15) * 16 + (x & 15);
      ASSERT_EQ(it->second.labels[in_tile], expected.label) << x << " " << y;
      ASSERT_EQ(it->second.hits[in_tile], expected.hits) << x << " " << y;
    }
  }
}

TEST(SemanticGridTest, EqualsADenseArray) {
  const std::vector<Label> labels{kUnlabeled, kRoad, kCar, kPole, kLast};
  for (const int seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> coordinate(-kReach, kReach - 1), hits(1, 3), percent(0, 99);
    SemanticGrid grid(0.1);
    DenseGrid dense;
    for (int i = 0; i < 3000; ++i) {
      const Label label = labels[random() % labels.size()];
      // Lumped, so that cells meet several labels, ties and, now and then, saturation.
      const CellIndex cell(coordinate(random), coordinate(random) / 4);
      const int count = percent(random) == 0 ? SemanticGrid::kMaxHits : hits(random);
      grid.AddHits(label, cell, count);
      dense.AddHits(label, cell, count);
    }
    ExpectEqual(grid, dense, labels);
    grid.RemoveLayers(MaskOf({kCar, kLast}));
    dense.Remove(kCar);
    dense.Remove(kLast);
    ExpectEqual(grid, dense, labels);
  }
}

TEST(SemanticGridTest, OrderOfHitsDoesNotShow) {
  SemanticGrid forward(0.1), backward(0.1);
  for (int i = 0; i < 100; ++i) {
    forward.AddHits(kRoad, {i * 7 % 60 - 30, i % 13});
    const int j = 99 - i;
    backward.AddHits(kRoad, {j * 7 % 60 - 30, j % 13});
  }
  const auto a = forward.LayerOf(kRoad), b = backward.LayerOf(kRoad);
  ASSERT_EQ(a.size(), b.size());
  for (auto i = a.begin(), j = b.begin(); i != a.end(); ++i, ++j) {
    EXPECT_TRUE(i->first == j->first);
    EXPECT_EQ(i->second->hits, j->second->hits);
  }
}

}  // namespace
}  // namespace cartographer::submap
