// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "test/cartographer/pose_graph/place_scenes.h"

namespace cartographer::pose_graph {
namespace {

constexpr PlaceLayersOptions kSharp{/*reach_m=*/10., /*cell_m=*/2., /*min_height_m=*/0.5,
                                    /*blur_m=*/0.};

class PlaceLayersTest : public ::testing::Test {
 protected:
  PlaceLayersTest()
      : labels_(ShippedLabels()),
        channels_(PlaceChannels::Create(ShippedPlaceOptions(), labels_).value()) {}

  void Add(double x, double y, double z, const std::string& name, int times = 1) {
    for (int i = 0; i < times; ++i) {
      cloud_.positions.push_back(Eigen::Vector3d(x, y, z).cast<float>());
      cloud_.labels.push_back(labels_.FromName(name).value());
      cloud_.certainties.push_back(1.f);
    }
  }

  std::vector<PlaceLayer> Draw(const PlaceLayersOptions& options = kSharp) const {
    return DrawPlaceLayers({{cloud_, transform::Rigid3d()}}, {0., 0.}, channels_, options);
  }
  const PlaceLayer& LayerOf(const std::vector<PlaceLayer>& layers, const std::string& name) const {
    return layers[channels_.ChannelOf(labels_.FromName(name).value())];
  }
  // Points that fill a cell of 2 m of the label.
  int Full(const std::string& name) const {
    const int channel = channels_.ChannelOf(labels_.FromName(name).value());
    return static_cast<int>(4.f * channels_[channel].saturation_hits);
  }

  const sensor::LabelSet labels_;
  const PlaceChannels channels_;
  sensor::LabeledPointCloud cloud_;
};

TEST_F(PlaceLayersTest, AreEmptyWhereNothingIs) {
  const auto layers = Draw();
  ASSERT_EQ(layers.size(), channels_.size());
  for (const PlaceLayer& layer : layers) {
    EXPECT_EQ(layer.rows(), 10);
    EXPECT_EQ(layer.cols(), 10);
    EXPECT_TRUE((layer == 0.f).all());
  }
}

TEST_F(PlaceLayersTest, CountPointsUntilACellIsFull) {
  const int full = Full("building");
  Add(-9.9, -9.9, 0., "road");
  Add(-9.9, -9.9, 2., "building", full / 4);
  Add(3.1, 0.1, 0., "road");
  Add(3.1, 0.1, 2., "building", 3 * full);
  Add(3.1, 0.1, 2., "vegetation", full / 2);
  const auto layers = Draw();
  const PlaceLayer& building = LayerOf(layers, "building");
  EXPECT_FLOAT_EQ(building(0, 0), 0.25f);
  EXPECT_FLOAT_EQ(building(5, 6), 1.f);
  EXPECT_FLOAT_EQ(building.sum(), 1.25f);
  EXPECT_FLOAT_EQ(LayerOf(layers, "vegetation")(5, 6), 0.5f);
}

TEST_F(PlaceLayersTest, LeaveOutWhatIsLowOrMayLeaveOrIsNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  // Both above ground that is 7 m high here.
  Add(1., 1., 7., "terrain");
  Add(1., 1., 7.4, "vegetation");
  Add(1., 1., 7.6, "fence");
  Add(5., 5., 0., "road");
  Add(5., 5., 2., "car", 100);
  Add(5., 5., 2., "moving-car", 100);
  Add(nan, 1., 2., "building");
  Add(1., 1., nan, "building");
  Add(10.1, 1., 2., "building");
  Add(1., 1e30, 2., "building");
  const auto layers = Draw();
  EXPECT_GT(LayerOf(layers, "fence")(5, 5), 0.f);
  float sum = 0.f;
  for (const PlaceLayer& layer : layers) sum += layer.sum();
  EXPECT_EQ(sum, LayerOf(layers, "fence")(5, 5));
}

TEST_F(PlaceLayersTest, BlurSpreadsWithoutLossToAllSidesAlike) {
  Add(1., 1., 0., "road");
  Add(1., 1., 2., "building", 2 * Full("building"));
  PlaceLayersOptions options = kSharp;
  options.reach_m = 30.;
  options.blur_m = 3.;
  const auto layers = Draw(options);
  const PlaceLayer& layer = LayerOf(layers, "building");
  EXPECT_NEAR(layer.sum(), 1.f, 1e-5);
  double variance_m2 = 0.;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 30; ++x) {
      EXPECT_EQ(layer(y, x), layer(x, y));
      variance_m2 += layer(y, x) * std::pow(2. * (x - 15), 2);
    }
  }
  EXPECT_NEAR(std::sqrt(variance_m2), 3., 0.1);
}

TEST_F(PlaceLayersTest, JoinsPartsWhereTheyStand) {
  Add(1., 3., 0., "road");
  Add(1., 3., 2., "building", 5);
  const auto together = Draw();
  // A quarter turn to the left and a step ahead; the second part brings the ground.
  const transform::Rigid3d frame_from_cloud(
      {104., 50., 1.}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ())));
  sensor::LabeledPointCloud ground, house;
  for (size_t i = 0; i < cloud_.size(); ++i) (i == 0 ? ground : house).Append(cloud_, i);
  const auto parts = DrawPlaceLayers({{house, frame_from_cloud}, {ground, frame_from_cloud}},
                                     {100., 48.}, channels_, kSharp);
  // From (1, 3) to (104 - 3, 50 + 1), which is (1, 3) from the centre.
  for (int i = 0; i < channels_.size(); ++i) EXPECT_TRUE((together[i] == parts[i]).all()) << i;
}

}  // namespace
}  // namespace cartographer::pose_graph
