// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/label_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/testing/test_files.h"
#include "test/testing/test_labels.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::sensor::kUnlabeled;
using cartographer::sensor::Label;
using cartographer::sensor::LabelSet;
using semantic_kiss_testing::SomeKittiLabels;
using semantic_kiss_testing::SomeKittiLabelsDeclaration;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using semantic_kiss_testing::WriteValues;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

class LabelFileTest : public ::testing::Test {
 protected:
  Label Named(const char* name) const { return set_.FromName(name).value(); }
  absl::Status Read(size_t num_points) {
    return ReadLabels({path_, num_points}, set_, &buffer_, &labels_, &unknown_ids_);
  }

  const LabelSet set_ = SomeKittiLabels();
  const TemporaryDirectory directory_;
  const std::string path_ = directory_ / "000003.label";
  FileBuffer buffer_;
  std::vector<Label> labels_;
  UnknownLabelIds unknown_ids_;
};

TEST_F(LabelFileTest, TakesTheLowBitsAndMerges) {
  WriteValues<uint32_t>(path_, {10, 10 | 7u << 16, 60, 0, 1, 255, 0xffff0000u | 80});
  ASSERT_TRUE(Read(7).ok());
  EXPECT_THAT(labels_, ElementsAre(Named("car"), Named("car"), Named("road"), kUnlabeled,
                                   kUnlabeled, Named("moving-motorcyclist"), Named("pole")));
  EXPECT_THAT(unknown_ids_, IsEmpty());
}

TEST_F(LabelFileTest, CountsIdsThatTheSetDoesNotList) {
  WriteValues<uint32_t>(path_, {300, 10, 300, 65535 | 1u << 16});
  ASSERT_TRUE(Read(4).ok());
  EXPECT_THAT(labels_, ElementsAre(kUnlabeled, Named("car"), kUnlabeled, kUnlabeled));
  EXPECT_THAT(unknown_ids_, ElementsAre(Pair(300, 2), Pair(65535, 1)));
}

TEST_F(LabelFileTest, AnEmptyScanHasAnEmptyFile) {
  WriteText(path_, "");
  EXPECT_TRUE(Read(0).ok());
  EXPECT_THAT(labels_, IsEmpty());
}

TEST_F(LabelFileTest, AnotherCountNamesFileAndBothCounts) {
  WriteValues<uint32_t>(path_, {10, 10});
  EXPECT_EQ(Read(3).message(),
            path_ + ": has 2 labels for a scan of 3 points; do both belong to the same sequence?");
  WriteText(path_, "123456789");
  EXPECT_EQ(Read(3).message(),
            path_ + ": size is 9 bytes, not a multiple of 4; labels are one uint32 a point");
}

TEST_F(LabelFileTest, AMissingFileIsNamed) {
  EXPECT_EQ(Read(1).code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(Read(1).message().substr(0, path_.size()), path_);
}

class MovingVariantsTest : public LabelFileTest {
 protected:
  const MovingVariants variants_ = MovingVariants::Create(set_).value();
};

TEST_F(MovingVariantsTest, FollowTheRule) {
  EXPECT_EQ(variants_.Of(Named("car")), Named("moving-car"));
  EXPECT_EQ(variants_.Of(Named("person")), Named("moving-person"));
  EXPECT_EQ(variants_.Of(Named("moving-person")), Named("moving-person"));
  EXPECT_EQ(variants_.Of(Named("bicycle")), Named("moving-car"));  // the first moving class
  EXPECT_EQ(variants_.Of(kUnlabeled), Named("moving-car"));
  EXPECT_EQ(variants_.Of(Named("road")), Named("road"));
  EXPECT_EQ(variants_.Of(Named("building")), Named("building"));
  EXPECT_EQ(variants_.Of(Named("pole")), Named("pole"));
}

TEST_F(MovingVariantsTest, MaskTurnsWhatMoves) {
  WriteValues<uint32_t>(path_, {9, 251, 0, 251 | 5u << 16, 9});
  labels_ = {Named("car"), Named("car"), Named("car"), Named("road"), Named("moving-car")};
  ASSERT_TRUE(variants_.ApplyMask(path_, &buffer_, &labels_).ok());
  EXPECT_THAT(labels_, ElementsAre(Named("car"), Named("moving-car"), Named("car"), Named("road"),
                                   Named("moving-car")));
}

TEST_F(MovingVariantsTest, MasksAreToldFromLabels) {
  WriteValues<uint32_t>(path_, {9, 40});
  labels_ = {kUnlabeled, kUnlabeled};
  EXPECT_EQ(variants_.ApplyMask(path_, &buffer_, &labels_).message(),
            path_ +
                ": point 1 has the value 40; a moving-object mask holds 9 (static), 251 (moving) "
                "or 0 (unknown)");
}

TEST_F(MovingVariantsTest, MaskMustFitTheScan) {
  WriteValues<uint32_t>(path_, {9});
  labels_ = {kUnlabeled, kUnlabeled};
  EXPECT_EQ(
      variants_.ApplyMask(path_, &buffer_, &labels_).message(),
      path_ + ": has 1 mask values for a scan of 2 points; do both belong to the same sequence?");
}

TEST_F(MovingVariantsTest, NeedAMovingClass) {
  cartographer::sensor::proto::LabelSet declaration = SomeKittiLabelsDeclaration();
  declaration.mutable_classes()->erase(declaration.classes().end() - 3,
                                       declaration.classes().end());
  EXPECT_EQ(MovingVariants::Create(LabelSet::Create(declaration).value()).status().message(),
            "label set \"some_kitti_labels\": no class has the role \"moving\", which "
            "moving-object masks need");
}

}  // namespace
}  // namespace semantic_kiss::dataset
