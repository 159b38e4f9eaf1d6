// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/certainty_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "test/testing/test_files.h"
#include "test/testing/test_labels.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::sensor::kUnlabeled;
using cartographer::sensor::Label;
using cartographer::sensor::LabelSet;
using semantic_kiss_testing::SomeKittiLabels;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using semantic_kiss_testing::WriteValues;
using ::testing::ElementsAre;
using ::testing::FloatNear;

class CertaintyReaderTest : public ::testing::Test {
 protected:
  Label Named(const char* name) const { return set_.FromName(name).value(); }

  // Columns: unlabeled, car, road, pole.
  std::string Error(const std::vector<Label>& labels) {
    return std::string(reader_.Read(path_, labels, &buffer_, &certainties_).message());
  }

  const LabelSet set_ = SomeKittiLabels();
  const CertaintyReader reader_ = CertaintyReader(set_, {0, 10, 40, 80});
  const TemporaryDirectory directory_;
  const std::string path_ = directory_ / "000003.conf";
  FileBuffer buffer_;
  std::vector<float> certainties_;
};

TEST_F(CertaintyReaderTest, TakesOneValueAPoint) {
  WriteValues<float>(path_, {0.f, 0.25f, 1.f});
  EXPECT_EQ(Error({Named("car"), Named("road"), kUnlabeled}), "");
  EXPECT_THAT(certainties_, ElementsAre(0.f, 0.25f, 1.f));
}

TEST_F(CertaintyReaderTest, TakesTheLabelsColumn) {
  WriteValues<float>(path_, {0.1f, 0.2f, 0.3f, 0.4f,  //
                             0.1f, 0.2f, 0.3f, 0.4f,  //
                             0.7f, 0.1f, 0.1f, 0.1f,  //
                             0.f, 1.f, 0.f, 0.f});
  EXPECT_EQ(Error({Named("road"), Named("pole"), kUnlabeled, Named("car")}), "");
  EXPECT_THAT(certainties_, ElementsAre(0.3f, 0.4f, 0.7f, 1.f));
}

TEST_F(CertaintyReaderTest, MovingClassesHaveTheirNamesakesColumnAndOthersTheirDefault) {
  WriteValues<float>(path_, {0.1f, 0.2f, 0.3f, 0.4f,  //
                             0.1f, 0.2f, 0.3f, 0.4f,  //
                             0.1f, 0.2f, 0.3f, 0.4f});
  EXPECT_EQ(Error({Named("moving-car"), Named("building"), Named("moving-motorcyclist")}), "");
  EXPECT_THAT(certainties_, ElementsAre(0.2f, 0.5f, 0.5f));
}

TEST_F(CertaintyReaderTest, AMovingClassKeepsAColumnOfItsOwn) {
  const CertaintyReader reader = CertaintyReader(set_, {10, 252});
  WriteValues<float>(path_, {0.25f, 0.75f});
  ASSERT_TRUE(reader.Read(path_, {Named("moving-car")}, &buffer_, &certainties_).ok());
  EXPECT_THAT(certainties_, ElementsAre(0.75f));
}

TEST_F(CertaintyReaderTest, SumsTheColumnsOfMergedClasses) {
  const CertaintyReader reader = CertaintyReader(set_, {40, 10, 60});
  WriteValues<float>(path_, {0.25f, 0.25f, 0.5f});
  ASSERT_TRUE(reader.Read(path_, {Named("road")}, &buffer_, &certainties_).ok());
  EXPECT_THAT(certainties_, ElementsAre(FloatNear(0.75f, 1e-6f)));
}

TEST_F(CertaintyReaderTest, RoundingNeverExceedsOne) {
  const CertaintyReader reader = CertaintyReader(set_, {40, 60});
  WriteValues<float>(path_, {0.503f, 0.503f});
  ASSERT_TRUE(reader.Read(path_, {Named("road")}, &buffer_, &certainties_).ok());
  EXPECT_THAT(certainties_, ElementsAre(1.f));
}

TEST_F(CertaintyReaderTest, DefaultsAreTheClasses) {
  reader_.FillDefaults({Named("road"), Named("car"), kUnlabeled}, &certainties_);
  EXPECT_THAT(certainties_, ElementsAre(0.9f, 0.5f, 0.5f));
}

TEST_F(CertaintyReaderTest, AnEmptyScanHasAnEmptyFile) {
  WriteText(path_, "");
  EXPECT_EQ(Error({}), "");
  EXPECT_TRUE(certainties_.empty());
}

TEST_F(CertaintyReaderTest, NamesTheSizesThatItCouldHave) {
  WriteValues<float>(path_, {0.5f, 0.5f, 0.5f});
  EXPECT_EQ(Error({kUnlabeled, kUnlabeled}),
            path_ +
                ": size is 12 bytes; for a scan of 2 points it is 8 (a certainty a point) or 32 "
                "(probabilities of 4 classes a point; option confidence_columns)");
}

TEST_F(CertaintyReaderTest, NamesTheValueThatIsNoProbability) {
  const std::vector<Label> labels(3, kUnlabeled);
  WriteValues<float>(path_, {0.5f, 1.f, 1.5f});
  EXPECT_EQ(Error(labels), path_ +
                               ": certainty of point 2 is 1.5, which is not in [0, 1]; "
                               "probabilities are needed, not logits or per cent");
  WriteValues<float>(path_, {0.5f, -0.25f, 1.5f});
  EXPECT_EQ(Error(labels).find(path_ + ": certainty of point 1 is -0.25, which"), 0);
  WriteValues<float>(path_, {NAN, 0.f, 0.f});
  EXPECT_EQ(Error(labels).find(path_ + ": certainty of point 0 is nan, which"), 0);
}

TEST_F(CertaintyReaderTest, NamesTheRowThatIsNoDistribution) {
  const std::vector<Label> labels(2, kUnlabeled);
  WriteValues<float>(path_, {1.f, 0.f, 0.f, 0.f, 0.5f, 0.f, 2.f, 0.f});
  EXPECT_EQ(Error(labels).find(path_ + ": certainty of point 1, column 2 is 2, which"), 0);
  WriteValues<float>(path_, {1.f, 0.f, 0.f, 0.f, 0.5f, 0.f, NAN, 0.f});
  EXPECT_EQ(Error(labels).find(path_ + ": certainty of point 1, column 2 is nan, which"), 0);
  WriteValues<float>(path_, {1.f, 0.f, 0.f, 0.f, 0.5f, 0.f, 0.25f, 0.f});
  EXPECT_EQ(Error(labels),
            path_ + ": probabilities of point 1 sum to 0.75, not to 1; are they softmax values?");
}

TEST_F(CertaintyReaderTest, NamesTheColumnOfAnUnknownClass) {
  const CertaintyReader reader(set_, {10, 77});
  WriteValues<float>(path_, {0.5f, 0.5f});
  EXPECT_EQ(reader.Read(path_, {kUnlabeled}, &buffer_, &certainties_).message(),
            path_ +
                ": column 1 stands for the id 77, which label set \"some_kitti_labels\" does "
                "not list; let dataset.confidence_columns name the ids of the file's columns");
  // Other files need no columns.
  WriteValues<float>(path_, {0.5f});
  EXPECT_TRUE(reader.Read(path_, {kUnlabeled}, &buffer_, &certainties_).ok());
}

TEST_F(CertaintyReaderTest, WithoutColumnsOnlyOneValueAPointWillDo) {
  const CertaintyReader reader = CertaintyReader(set_, {});
  WriteText(path_, "");
  EXPECT_FALSE(reader.Read(path_, {kUnlabeled}, &buffer_, &certainties_).ok());
  WriteValues<float>(path_, {0.5f});
  EXPECT_TRUE(reader.Read(path_, {kUnlabeled}, &buffer_, &certainties_).ok());
}

}  // namespace
}  // namespace semantic_kiss::dataset
