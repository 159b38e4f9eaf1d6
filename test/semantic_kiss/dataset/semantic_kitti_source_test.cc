// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/semantic_kitti_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "cartographer/common/options_loader.h"
#include "test/testing/test_files.h"
#include "test/testing/test_labels.h"
#include "test/testing/test_sequence.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::common::ToUnixSeconds;
using cartographer::sensor::kUnlabeled;
using cartographer::sensor::Label;
using cartographer::sensor::LabeledScan;
using cartographer::sensor::LabelSet;
using cartographer::transform::Rigid3d;
using semantic_kiss_testing::RawScan;
using semantic_kiss_testing::ScanStreet;
using semantic_kiss_testing::SomeKittiLabels;
using semantic_kiss_testing::SourceFile;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::TestCameraFromLidar;
using semantic_kiss_testing::TestCertainties;
using semantic_kiss_testing::TestSequenceFiles;
using semantic_kiss_testing::TestStreet;
using semantic_kiss_testing::WriteTestSequence;
using semantic_kiss_testing::WriteText;
using semantic_kiss_testing::WriteValues;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

// The options that are shipped.
proto::DatasetOptions ShippedOptions() {
  proto::DatasetOptions options;
  const absl::Status status = cartographer::common::LoadOptionsFromString(
      "include \"defaults/dataset.lua\"\nreturn DATASET", "test",
      {SourceFile("configuration_files")}, &options);
  EXPECT_TRUE(status.ok()) << status;
  return options;
}

class SemanticKittiSourceTest : public ::testing::Test {
 protected:
  // Options of an exact sensor; SomeKittiLabels() lacks most of the shipped columns.
  SemanticKittiSourceTest() {
    options_ = ShippedOptions();
    options_.set_vertical_correction_deg(0.);
    options_.clear_confidence_columns();
  }

  void Write(const TestSequenceFiles& files = {}) {
    WriteTestSequence(root_.path(), street_, files);
  }
  auto Open(const ScanRange& range = {}) {
    return OpenSemanticKitti(location_, range, options_, labels_);
  }
  std::string OpenError() { return std::string(Open().status().message()); }
  std::string ReadError(int index) {
    return std::string(Open().value()->Read(index).status().message());
  }
  // Overwrites the first scan of the sequence.
  void WriteFirstScan(size_t num_points, const std::vector<uint32_t>& ids) {
    WriteValues(sequence_ + "/velodyne/000000.bin", std::vector<float>(4 * num_points, 1.f));
    WriteValues(sequence_ + "/labels/000000.label", ids);
  }

  const TemporaryDirectory root_;
  const std::string sequence_ = root_ / "sequences/00";
  TestStreet street_{3, 0.5, 0.1, 1, 0.1};
  SemanticKittiLocation location_{root_.path(), "00", ""};
  proto::DatasetOptions options_;
  const LabelSet labels_ = SomeKittiLabels();
};

TEST_F(SemanticKittiSourceTest, ReadsWhatWasWritten) {
  Write();
  const std::unique_ptr<ScanSource> source = Open().value();
  ASSERT_EQ(source->size(), 3);
  for (int i = 0; i < 3; ++i) {
    const LabeledScan scan = source->Read(i).value();
    const RawScan raw = ScanStreet(street_, i);
    scan.points.CheckConsistent();
    EXPECT_EQ(scan.index, i);
    EXPECT_NEAR(ToUnixSeconds(scan.time), 0.1 * i, 1e-9);
    ASSERT_EQ(scan.points.size(), raw.num_points());
    ASSERT_GT(scan.points.size(), 100);
    for (size_t p = 0; p < raw.num_points(); ++p) {
      ASSERT_EQ(scan.points.positions[p], Eigen::Vector3f(&raw.rows[4 * p]));
      ASSERT_EQ(scan.points.intensities[p], raw.rows[4 * p + 3]);
      ASSERT_EQ(labels_.FileId(scan.points.labels[p]), raw.ids[p]);
      ASSERT_EQ(scan.points.certainties[p], labels_.DefaultCertainty(scan.points.labels[p]));
    }
    EXPECT_THAT(scan.points.times, IsEmpty());
  }
  EXPECT_THAT(source->unknown_label_ids(), IsEmpty());
  EXPECT_EQ(source->labels().size(), labels_.size());
}

TEST_F(SemanticKittiSourceTest, GroundTruthIsOfTheLidar) {
  Write();
  const std::unique_ptr<ScanSource> source = Open().value();
  ASSERT_TRUE(source->ground_truth().has_value());
  ASSERT_EQ(source->ground_truth()->size(), 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(((*source->ground_truth())[i].Matrix() - street_.StreetFromSensor(i).Matrix()).norm(),
              1e-9);
  }
  ASSERT_TRUE(source->camera_from_sensor().has_value());
  EXPECT_LT((source->camera_from_sensor()->Matrix() - TestCameraFromLidar().Matrix()).norm(), 1e-9);
}

TEST_F(SemanticKittiSourceTest, WithoutCalibrationPosesAreTheLidars) {
  TestSequenceFiles files;
  files.calibration = false;
  Write(files);
  const std::unique_ptr<ScanSource> source = Open().value();
  EXPECT_FALSE(source->camera_from_sensor().has_value());
  EXPECT_LT(((*source->ground_truth())[2].Matrix() - street_.StreetFromSensor(2).Matrix()).norm(),
            1e-9);
  EXPECT_THAT(source->notes(), Contains("no Tr in calib.txt: poses are taken as the lidar's own"));
}

TEST_F(SemanticKittiSourceTest, ScansAloneWillDo) {
  TestSequenceFiles files;
  files.labels = files.times = files.calibration = files.ground_truth = false;
  Write(files);
  const std::unique_ptr<ScanSource> source = Open().value();
  const LabeledScan scan = source->Read(2).value();
  scan.points.CheckConsistent();
  EXPECT_THAT(scan.points.labels, Each(kUnlabeled));
  EXPECT_THAT(scan.points.certainties, Each(0.5f));
  EXPECT_NEAR(ToUnixSeconds(scan.time), 0.2, 1e-9);
  EXPECT_FALSE(source->ground_truth().has_value());
  EXPECT_THAT(source->notes(), Contains("no times.txt: 10 Hz are assumed"));
}

TEST_F(SemanticKittiSourceTest, LinesBelongToNumbers) {
  street_.num_scans = 5;
  Write();
  std::filesystem::remove(sequence_ + "/velodyne/000000.bin");
  const std::unique_ptr<ScanSource> source = Open({2, 2}).value();
  ASSERT_EQ(source->size(), 2);
  const LabeledScan scan = source->Read(1).value();
  EXPECT_EQ(scan.index, 3);
  EXPECT_NEAR(ToUnixSeconds(scan.time), 0.3, 1e-9);
  ASSERT_EQ(source->ground_truth()->size(), 2);
  // The frame stays that of the whole drive.
  EXPECT_LT(((*source->ground_truth())[1].Matrix() - street_.StreetFromSensor(3).Matrix()).norm(),
            1e-9);
}

TEST_F(SemanticKittiSourceTest, BothFormsOfCertaintiesSayTheSame) {
  const LabelSet labels = LabelSet::Create([] {
                            auto declaration = semantic_kiss_testing::SomeKittiLabelsDeclaration();
                            for (const int id : {15, 31, 32, 44, 49, 51, 72}) {
                              auto* const entry = declaration.add_classes();
                              *entry = declaration.classes(9);
                              entry->set_id(id);
                              entry->set_name(std::to_string(id));
                            }
                            return declaration;
                          }())
                              .value();
  *options_.mutable_confidence_columns() = ShippedOptions().confidence_columns();
  for (const TestCertainties kind : {TestCertainties::kPerPoint, TestCertainties::kPerClass}) {
    TestSequenceFiles files;
    files.certainties = kind;
    Write(files);
    const auto source = OpenSemanticKitti(location_, {}, options_, labels).value();
    EXPECT_THAT(source->Read(0).value().points.certainties, Each(FloatNear(0.8f, 1e-6f)));
  }
}

TEST_F(SemanticKittiSourceTest, RaisesPointsByTheCorrection) {
  Write();
  const LabeledScan before = Open().value()->Read(0).value();
  options_.set_vertical_correction_deg(0.205);
  const LabeledScan after = Open().value()->Read(0).value();
  for (size_t i = 0; i < before.points.size(); ++i) {
    const Eigen::Vector3d a = before.points.positions[i].cast<double>();
    const Eigen::Vector3d b = after.points.positions[i].cast<double>();
    ASSERT_NEAR(std::atan2(b.z(), b.head<2>().norm()) - std::atan2(a.z(), a.head<2>().norm()),
                0.205 * M_PI / 180., 1e-6);
  }
}

TEST_F(SemanticKittiSourceTest, ReadsTimesOfPoints) {
  Write();
  for (const char* stem : {"000000", "000001"}) {
    WriteValues(sequence_ + "/point_times/" + stem + ".bin",
                std::vector<float>(ScanStreet(street_, 0).num_points(), -0.05f));
  }
  EXPECT_THAT(Open().value()->Read(0).value().points.times, Each(-0.05f));
  EXPECT_THAT(ReadError(1), HasSubstr(sequence_ + "/point_times/000001.bin: size is "));
  EXPECT_THAT(ReadError(2), HasSubstr(sequence_ + "/point_times/000002.bin: cannot be read"));
}

TEST_F(SemanticKittiSourceTest, AppliesMovingMasks) {
  Write();
  WriteFirstScan(3, {10, 10, 40});
  WriteValues<uint32_t>(root_ / "sequences/00/masks/000000.label", {9, 251, 251});
  options_.set_moving_masks_dir("masks");
  EXPECT_THAT(Open().value()->Read(0).value().points.labels,
              ElementsAre(*labels_.FromName("car"), *labels_.FromName("moving-car"),
                          *labels_.FromName("road")));
}

TEST_F(SemanticKittiSourceTest, CountsUnknownIdsOfScansThatWereRead) {
  Write();
  WriteFirstScan(4, {10, 300, 300, 301});
  const std::unique_ptr<ScanSource> source = Open().value();
  EXPECT_THAT(source->unknown_label_ids(), IsEmpty());
  ASSERT_TRUE(source->Read(0).ok());
  EXPECT_THAT(source->unknown_label_ids(), ElementsAre(Pair(300, 2), Pair(301, 1)));
  ASSERT_TRUE(source->Read(1).ok());
  ASSERT_TRUE(source->Read(0).ok());
  EXPECT_THAT(source->unknown_label_ids(), ElementsAre(Pair(300, 4), Pair(301, 2)));
}

TEST_F(SemanticKittiSourceTest, AnEmptyScanIsAScan) {
  Write();
  WriteFirstScan(0, {});
  const LabeledScan scan = Open().value()->Read(0).value();
  EXPECT_TRUE(scan.points.empty());
  scan.points.CheckConsistent();
}

TEST_F(SemanticKittiSourceTest, PointsThatAreNotFinitePass) {
  Write();
  WriteFirstScan(2, {10, 10});
  WriteValues<float>(sequence_ + "/velodyne/000000.bin",
                     {NAN, NAN, NAN, 0.f, INFINITY, 0.f, 0.f, 0.f});
  options_.set_vertical_correction_deg(0.205);
  const LabeledScan scan = Open().value()->Read(0).value();
  ASSERT_EQ(scan.points.size(), 2);
  EXPECT_FALSE(scan.points.positions[0].allFinite());
  EXPECT_FALSE(scan.points.positions[1].allFinite());
}

TEST_F(SemanticKittiSourceTest, ABadScanDoesNotSpoilTheOthers) {
  Write();
  WriteFirstScan(3, {10, 10});
  const std::unique_ptr<ScanSource> source = Open().value();
  EXPECT_EQ(source->Read(0).status().message(),
            sequence_ +
                "/labels/000000.label: has 2 labels for a scan of 3 points; do both belong to the "
                "same sequence?");
  EXPECT_TRUE(source->Read(1).ok());
}

TEST_F(SemanticKittiSourceTest, ErrorsOfScansNameTheirFiles) {
  Write();
  WriteText(sequence_ + "/velodyne/000000.bin", "seventeen bytes..");
  EXPECT_THAT(ReadError(0), HasSubstr(sequence_ + "/velodyne/000000.bin: size is 17 bytes"));
  std::filesystem::remove(sequence_ + "/labels/000001.label");
  EXPECT_THAT(ReadError(1), HasSubstr(sequence_ + "/labels/000001.label: cannot be read"));
  WriteFirstScan(2, {10, 10});
  WriteValues<float>(sequence_ + "/confidences/000000.conf", {0.5f, 2.f});
  EXPECT_THAT(ReadError(0),
              HasSubstr(sequence_ + "/confidences/000000.conf: certainty of point 1 is 2"));
}

TEST_F(SemanticKittiSourceTest, TimesAndPosesMustReachTheLastScan) {
  Write();
  WriteText(sequence_ + "/times.txt", "0\n0.1\n");
  EXPECT_EQ(OpenError(),
            sequence_ +
                "/times.txt: has 2 lines, but the scans go to 000002.bin; a line for every scan "
                "from number 0 on is needed");
  WriteText(sequence_ + "/times.txt", "0\n0.1\n0.2\n0.3\n");
  EXPECT_EQ(OpenError(), "");
  WriteText(root_ / "poses/00.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(OpenError(), HasSubstr((root_ / "poses/00.txt") + ": has 1 lines, but the scans"));
}

TEST_F(SemanticKittiSourceTest, ErrorsOfTheDriveNameFileAndLine) {
  Write();
  WriteText(root_ / "poses/00.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1\n");
  EXPECT_THAT(OpenError(), HasSubstr((root_ / "poses/00.txt") + ":2: "));
  WriteText(root_ / "poses/00.txt", "1 0 0 0 0 1 0 0 0 0 2 0\n");
  EXPECT_THAT(OpenError(), HasSubstr((root_ / "poses/00.txt") + ":1: "));
  WriteText(sequence_ + "/calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: 1 0 0\n");
  EXPECT_THAT(OpenError(), HasSubstr(sequence_ + "/calib.txt:2: "));
  WriteText(sequence_ + "/times.txt", "0\n0.1\n0.05\n");
  EXPECT_THAT(OpenError(), HasSubstr(sequence_ + "/times.txt:3: the time is 0.05"));
}

TEST(DatasetOptionsTest, ShippedColumnsAreTheBenchmarks20Classes) {
  const proto::DatasetOptions options = ShippedOptions();
  EXPECT_EQ(options.vertical_correction_deg(), 0.205);
  EXPECT_THAT(options.confidence_columns(), ElementsAre(0, 10, 11, 15, 18, 20, 30, 31, 32, 40, 44,
                                                        48, 49, 50, 51, 70, 71, 72, 80, 81));
}

}  // namespace
}  // namespace semantic_kiss::dataset
