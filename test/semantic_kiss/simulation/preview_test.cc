// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/preview.h"

#include <gtest/gtest.h>

#include "semantic_kiss/simulation/scan_preview.h"

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

TEST(ScanPreviewTest, DrawsAPngOfTheScan) {
  const semantic_kiss_testing::TemporaryDirectory directory;
  const auto drive = SmallDrive();
  const auto labels = semantic_kiss_testing::ShippedLabels();
  ASSERT_TRUE(DrawScanPreview(*drive, 0, labels, directory / "a.png").ok());
  ASSERT_TRUE(DrawScanPreview(*drive, 0, labels, directory / "b.png").ok());
  ASSERT_TRUE(DrawScanPreview(*drive, 5, labels, directory / "c.png").ok());
  const std::string png = semantic_kiss_testing::ReadText(directory / "a.png");
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_TRUE(png == semantic_kiss_testing::ReadText(directory / "b.png"));
  EXPECT_FALSE(png == semantic_kiss_testing::ReadText(directory / "c.png"));
  EXPECT_FALSE(DrawScanPreview(*drive, 0, labels, directory / "none/d.png").ok());
  EXPECT_DEATH(DrawScanPreview(*drive, 100000, labels, directory / "e.png").ok(), "100000");
}

}  // namespace
}  // namespace semantic_kiss::simulation
