// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/semantic_kitti_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "test/testing/test_files.h"

namespace semantic_kiss::dataset {
namespace {

using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SemanticKittiLayoutTest : public ::testing::Test {
 protected:
  SemanticKittiLayoutTest() {
    options_.set_assumed_rate_hz(10.);
    options_.set_confidences_dir("confidences");
    MakeDirectory("velodyne");
  }

  void MakeDirectory(const std::string& name) {
    std::filesystem::create_directories(sequence_ + "/" + name);
  }
  SemanticKittiLayout Find(const std::string& labels_dir = "") {
    location_.labels_dir = labels_dir;
    return FindSemanticKittiFiles(location_, options_).value();
  }
  std::string Error() {
    const absl::Status status = FindSemanticKittiFiles(location_, options_).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
    return std::string(status.message());
  }

  const TemporaryDirectory root_;
  const std::string sequence_ = root_ / "sequences/07";
  SemanticKittiLocation location_{root_.path(), "07", ""};
  proto::DatasetOptions options_;
};

TEST_F(SemanticKittiLayoutTest, ScansAloneWillDo) {
  const SemanticKittiLayout layout = Find();
  EXPECT_EQ(layout.velodyne_dir, sequence_ + "/velodyne");
  for (const std::string& path :
       {layout.labels_dir, layout.confidences_dir, layout.moving_masks_dir, layout.point_times_dir,
        layout.times_file, layout.calib_file, layout.poses_file}) {
    EXPECT_THAT(path, IsEmpty());
  }
  EXPECT_THAT(layout.notes, Contains("no labels: every point is unlabeled"));
  EXPECT_THAT(layout.notes, Contains("no times.txt: 10 Hz are assumed"));
  EXPECT_THAT(layout.notes, Contains("no ground truth"));
}

TEST_F(SemanticKittiLayoutTest, FindsEverything) {
  for (const char* name : {"labels", "confidences", "point_times", "masks"}) MakeDirectory(name);
  for (const char* name : {"times.txt", "calib.txt", "poses.txt"}) {
    WriteText(sequence_ + "/" + name, "");
  }
  options_.set_moving_masks_dir("masks");
  const SemanticKittiLayout layout = Find();
  EXPECT_EQ(layout.labels_dir, sequence_ + "/labels");
  EXPECT_EQ(layout.confidences_dir, sequence_ + "/confidences");
  EXPECT_EQ(layout.moving_masks_dir, sequence_ + "/masks");
  EXPECT_EQ(layout.point_times_dir, sequence_ + "/point_times");
  EXPECT_EQ(layout.times_file, sequence_ + "/times.txt");
  EXPECT_EQ(layout.calib_file, sequence_ + "/calib.txt");
  EXPECT_EQ(layout.poses_file, sequence_ + "/poses.txt");
  EXPECT_THAT(layout.notes, Contains("labels from " + sequence_ + "/labels"));
  EXPECT_THAT(layout.notes, Contains("certainties from " + sequence_ + "/confidences"));
  EXPECT_THAT(layout.notes, Contains("moving-object masks from " + sequence_ + "/masks"));
}

TEST_F(SemanticKittiLayoutTest, PrefersTheBenchmarksGroundTruth) {
  WriteText(sequence_ + "/poses.txt", "");
  WriteText(root_ / "poses/07.txt", "");
  const SemanticKittiLayout layout = Find();
  EXPECT_EQ(layout.poses_file, root_ / "poses/07.txt");
  EXPECT_THAT(layout.notes, Contains("ground truth from " + (root_ / "poses/07.txt")));
}

TEST_F(SemanticKittiLayoutTest, GroundTruthMayBeElsewhere) {
  WriteText(sequence_ + "/poses.txt", "");
  WriteText(root_ / "better.txt", "");
  location_.ground_truth_file = root_ / "better.txt";
  EXPECT_EQ(Find().poses_file, root_ / "better.txt");
  location_.ground_truth_file = root_ / "none.txt";
  EXPECT_THAT(Error(), HasSubstr("none.txt: no such file; it was named as the ground truth"));
}

TEST_F(SemanticKittiLayoutTest, LabelsMayBeLeftOut) {
  MakeDirectory("labels");
  MakeDirectory("confidences");
  const SemanticKittiLayout layout = Find(kNoLabels);
  EXPECT_THAT(layout.labels_dir, IsEmpty());
  EXPECT_THAT(layout.confidences_dir, IsEmpty());
}

TEST_F(SemanticKittiLayoutTest, LabelsMayBeElsewhere) {
  const TemporaryDirectory other;
  MakeDirectory("predictions");
  EXPECT_EQ(Find("predictions").labels_dir, sequence_ + "/predictions");
  EXPECT_EQ(Find(other.path()).labels_dir, other.path());
  std::filesystem::create_directories(other / "sequences/07/predictions");
  std::filesystem::create_directories(other / "sequences/07/confidences");
  EXPECT_EQ(Find(other.path()).labels_dir, other / "sequences/07/predictions");
  // Certainties belong to the labels, so they are looked for beside them.
  EXPECT_EQ(Find(other.path()).confidences_dir, other / "sequences/07/confidences");
}

TEST_F(SemanticKittiLayoutTest, MasksMayBeElsewhere) {
  const TemporaryDirectory other;
  options_.set_moving_masks_dir(other.path());
  EXPECT_EQ(Find().moving_masks_dir, other.path());
  std::filesystem::create_directories(other / "sequences/07/predictions");
  EXPECT_EQ(Find().moving_masks_dir, other / "sequences/07/predictions");
}

TEST_F(SemanticKittiLayoutTest, CertaintiesMayBeElsewhereOrSwitchedOff) {
  const TemporaryDirectory other;
  MakeDirectory("labels");
  MakeDirectory("confidences");
  options_.set_confidences_dir(other.path());
  EXPECT_EQ(Find().confidences_dir, other.path());
  options_.set_confidences_dir("");
  EXPECT_THAT(Find().confidences_dir, IsEmpty());
  EXPECT_THAT(Find().notes, Contains("certainties of the labels from the label set"));
  options_.set_confidences_dir("/missing/confidences");
  EXPECT_EQ(Error(), "/missing/confidences: no such directory for the certainties");
}

TEST_F(SemanticKittiLayoutTest, SaysWhichDirectoryIsMissing) {
  location_.directory = root_ / "elsewhere";
  EXPECT_EQ(Error(),
            location_.directory + ": no such directory; give the one that holds sequences/07");
  location_.directory = sequence_;
  EXPECT_EQ(Error(), sequence_ +
                         ": has no directory sequences; scans are expected in "
                         "sequences/07/velodyne");
}

TEST_F(SemanticKittiLayoutTest, SaysWhichSequencesThereAre) {
  std::filesystem::create_directories(root_ / "sequences/03");
  location_.sequence = "99";
  EXPECT_EQ(Error(), (root_ / "sequences") + ": has no sequence \"99\" but 03, 07");
  location_.sequence = "";
  EXPECT_EQ(Error(), (root_ / "sequences") + ": has no sequence \"\" but 03, 07");
  location_.sequence = "03";
  EXPECT_EQ(Error(), (root_ / "sequences/03") + ": has no directory velodyne with the scans");
}

TEST_F(SemanticKittiLayoutTest, WhatIsNamedMustBeThere) {
  location_.labels_dir = "predictions";
  EXPECT_EQ(Error(), sequence_ +
                         "/predictions: no such directory for the labels; give an absolute path if "
                         "it is elsewhere");
  location_.labels_dir = "/missing/labels";
  EXPECT_EQ(Error(), "/missing/labels: no such directory for the labels");
  location_.labels_dir = "";
  options_.set_moving_masks_dir("masks");
  EXPECT_EQ(Error(), sequence_ +
                         "/masks: no such directory for the moving-object masks; give an absolute "
                         "path if it is elsewhere");
}

}  // namespace
}  // namespace semantic_kiss::dataset
