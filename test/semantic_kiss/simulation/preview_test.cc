// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/preview.h"

#include <gtest/gtest.h>

#include "test/semantic_kiss/simulation/small_drive.h"
#include "test/testing/odometry_on_sequence.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::simulation {
namespace {

TEST(PreviewTest, DrawsAPng) {
  const semantic_kiss_testing::TemporaryDirectory directory;
  const auto drive = SmallDrive();
  const auto labels = semantic_kiss_testing::ShippedLabels();
  ASSERT_TRUE(DrawPreview(*drive, labels, directory / "a.png").ok());
  ASSERT_TRUE(DrawPreview(*drive, labels, directory / "b.png").ok());
  const std::string png = semantic_kiss_testing::ReadText(directory / "a.png");
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_TRUE(png == semantic_kiss_testing::ReadText(directory / "b.png"));
  EXPECT_FALSE(DrawPreview(*drive, labels, directory / "none/c.png").ok());
}

}  // namespace
}  // namespace semantic_kiss::simulation
