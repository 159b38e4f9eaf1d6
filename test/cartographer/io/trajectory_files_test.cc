// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/trajectory_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "cartographer/transform/se3.h"

namespace cartographer::io {
namespace {

using ::testing::HasSubstr;
using transform::Rigid3d;

constexpr char kIdentityRow[] = "1 0 0 0 0 1 0 0 0 0 1 0\n";

class TrajectoryFilesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    directory_ = std::filesystem::path(::testing::TempDir()) / info->name();
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string PathOf(const std::string& name) const { return (directory_ / name).string(); }
  std::string MakeFile(const std::string& name, const std::string& content) const {
    std::ofstream(PathOf(name), std::ios::binary) << content;
    return PathOf(name);
  }
  std::string ContentOf(const std::string& name) const {
    std::ifstream file(PathOf(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  // The error that reading `content` as poses gives.
  absl::Status ErrorOf(const std::string& content) const {
    return ReadKittiPoses(MakeFile("poses.txt", content)).status();
  }

  std::filesystem::path directory_;
};

TEST_F(TrajectoryFilesTest, ReadsRowsAsMatrices) {
  const auto poses =
      ReadKittiPoses(MakeFile("p.txt", std::string(kIdentityRow) + "0 -1 0 1 1 0 0 2 0 0 1 3\n"));
  ASSERT_TRUE(poses.ok()) << poses.status();
  ASSERT_EQ(poses->size(), 2);
  EXPECT_EQ((*poses)[0].Matrix(), Rigid3d().Matrix());
  EXPECT_LT(((*poses)[1] * Eigen::Vector3d::UnitX() - Eigen::Vector3d(1., 3., 3.)).norm(), 1e-12);
}

TEST_F(TrajectoryFilesTest, AcceptsTabsCarriageReturnsAndAMissingLastNewline) {
  const auto poses = ReadKittiPoses(
      MakeFile("p.txt", " 1\t0 0 5e0 0 1 0 0 0 0 1  0 \r\n1 0 0 6 0 1 0 0 0 0 1 0\r\n\r\n"));
  ASSERT_TRUE(poses.ok()) << poses.status();
  ASSERT_EQ(poses->size(), 2);
  EXPECT_EQ((*poses)[1].translation().x(), 6.);
}

TEST_F(TrajectoryFilesTest, RoundedRotationsAreMadeOrthonormal) {
  const auto poses =
      ReadKittiPoses(MakeFile("p.txt", "0.8660 -0.5000 0 0 0.5000 0.8660 0 0 0 0 1.0000 0\n"));
  ASSERT_TRUE(poses.ok()) << poses.status();
  const Eigen::Matrix3d rotation = poses->front().Matrix().leftCols<3>();
  EXPECT_LT((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_NEAR(transform::RotationAngle(poses->front()), M_PI / 6., 1e-4);
}

TEST_F(TrajectoryFilesTest, MissingAndUnreadableFiles) {
  const absl::Status missing = ReadKittiPoses(PathOf("none.txt")).status();
  EXPECT_EQ(missing.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(missing.message()), HasSubstr("none.txt: no such file"));
  const absl::Status directory = ReadKittiPoses(directory_.string()).status();
  EXPECT_EQ(directory.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(directory.message()), HasSubstr("cannot be read"));
}

TEST_F(TrajectoryFilesTest, EmptyFilesHaveNoPoses) {
  for (const char* content : {"", "\n", " \r\n \n"}) {
    const absl::Status status = ErrorOf(content);
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(status.message()), HasSubstr("poses.txt: has no poses"));
  }
}

TEST_F(TrajectoryFilesTest, MalformedLinesAreNamedWithTheirValue) {
  struct Case {
    std::string line, expected;
  };
  const Case cases[] = {
      {"1 0 0 0 0 1 0 0 0 0 1", "poses.txt:2: has 11 numbers"},
      {"1 0 0 0 0 1 0 0 0 0 1 0 7", "poses.txt:2: has 13 numbers"},
      {"", "poses.txt:2: has 0 numbers"},
      {"1 0 0 0 0 1 0 x9 0 0 1 0", "poses.txt:2: `x9` is not a finite number"},
      {"1 0 0 nan 0 1 0 0 0 0 1 0", "poses.txt:2: `nan` is not a finite number"},
      {"1 0 0 0 0 1 0 0 0 0 1 -inf", "poses.txt:2: `-inf` is not a finite number"},
      {"1 0 0 0 0 1 0 1e999 0 0 1 0", "poses.txt:2: `1e999` is not a finite number"},
      {std::string("1 0 0 0 0 1 0 \x01 0 0 1 0"), "poses.txt:2: `\\x01` is not a finite number"},
  };
  for (const Case& test : cases) {
    const absl::Status status = ErrorOf(kIdentityRow + test.line + "\n" + kIdentityRow);
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(status.message()), HasSubstr(test.expected));
  }
}

TEST_F(TrajectoryFilesTest, OnlyRotationsPass) {
  const char* const kNoRotations[] = {
      "1.001 0 0 0 0 1 0 0 0 0 1 0",   // a scale
      "-1 0 0 0 0 1 0 0 0 0 1 0",      // a reflection
      "0 0 0 0 0 0 0 0 0 0 0 0",       // nothing
      "1 0 0 0 1 0 0 0 1 0 0 0",       // 3 x 3 blocks one after the other
      "1e200 0 0 0 0 1 0 0 0 0 1 0"};  // overflows when squared
  for (const char* const line : kNoRotations) {
    const absl::Status status = ErrorOf(line);
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << line;
    EXPECT_THAT(std::string(status.message()), HasSubstr("poses.txt:1: the left 3 x 3 block"));
  }
}

TEST_F(TrajectoryFilesTest, ReadsTheCalibrationRowOfTheLidar) {
  const auto camera_from_lidar = ReadKittiCalibration(
      MakeFile("calib.txt", "P0: 7 0 6 0 0 7 1 0 0 0 1 0\nTr: 0 -1 0 .1 0 0 -1 .2 1 0 0 .3\n"));
  ASSERT_TRUE(camera_from_lidar.ok()) << camera_from_lidar.status();
  // The camera looks along z and has y downwards.
  EXPECT_LT(
      (camera_from_lidar->rotation() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitZ()).norm(),
      1e-12);
  EXPECT_EQ(camera_from_lidar->translation(), Eigen::Vector3d(.1, .2, .3));
}

TEST_F(TrajectoryFilesTest, CalibrationErrors) {
  EXPECT_EQ(ReadKittiCalibration(PathOf("none.txt")).status().code(), absl::StatusCode::kNotFound);
  const absl::Status no_row = ReadKittiCalibration(MakeFile("a.txt", "P0: 1 2 3\n")).status();
  EXPECT_EQ(no_row.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(no_row.message()), HasSubstr("a.txt: has no row `Tr:`"));
  const absl::Status short_row = ReadKittiCalibration(MakeFile("b.txt", "\nTr: 1 2 3\n")).status();
  EXPECT_EQ(short_row.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(short_row.message()), HasSubstr("b.txt:2: has 3 numbers"));
}

TEST_F(TrajectoryFilesTest, PosesOfOtherBodyComeBack) {
  transform::Twist twist;
  twist << 1., 2., 3., .4, -.5, .6;
  const Rigid3d b_from_a = transform::Exp(twist);
  const std::vector<Rigid3d> a_poses = {Rigid3d(), transform::Exp(.5 * twist.reverse())};
  const std::vector<Rigid3d> b_poses = PosesOfOtherBody(a_poses, b_from_a);
  ASSERT_EQ(b_poses.size(), 2);
  EXPECT_LT((b_poses[0].Matrix() - Rigid3d().Matrix()).norm(), 1e-12);
  EXPECT_GT((b_poses[1].Matrix() - a_poses[1].Matrix()).norm(), 1e-2);
  const std::vector<Rigid3d> back = PosesOfOtherBody(b_poses, b_from_a.inverse());
  EXPECT_LT((back[1].Matrix() - a_poses[1].Matrix()).norm(), 1e-12);
  EXPECT_TRUE(PosesOfOtherBody({}, b_from_a).empty());
}

TEST_F(TrajectoryFilesTest, WhatIsWrittenReadsBackExactly) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::vector<Rigid3d> poses;
  for (int i = 0; i < 100; ++i) {
    transform::Twist twist;
    for (int k = 0; k < 6; ++k) twist[k] = (k < 3 ? 1e3 : 2.) * uniform(random);
    poses.push_back(transform::Exp(twist));
  }
  ASSERT_TRUE(WriteKittiPoses(PathOf("p.txt"), poses).ok());
  const auto read = ReadKittiPoses(PathOf("p.txt"));
  ASSERT_TRUE(read.ok()) << read.status();
  ASSERT_EQ(read->size(), poses.size());
  for (size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ((*read)[i].translation(), poses[i].translation());
    // The quaternion comes back by way of the matrix: only to round-off.
    EXPECT_LT((*read)[i].rotation().angularDistance(poses[i].rotation()), 1e-14);
  }
}

TEST_F(TrajectoryFilesTest, KittiRowsAreMatricesRowByRow) {
  ASSERT_TRUE(
      WriteKittiPoses(PathOf("p.txt"), {Rigid3d(), Rigid3d::Translation({0.1, -2., 1e-20})}).ok());
  EXPECT_EQ(ContentOf("p.txt"),
            "1 0 0 0 0 1 0 0 0 0 1 0\n"
            "1 0 0 0.10000000000000001 0 1 0 -2 0 0 1 9.9999999999999995e-21\n");
}

TEST_F(TrajectoryFilesTest, TumRowsAreTimePositionQuaternion) {
  const common::Time after = common::kUnixEpoch + common::Duration{12'345'678'900'000'001};
  const common::Time before = common::kUnixEpoch - common::Duration{5'000'000};
  ASSERT_TRUE(WriteTumPoses(
                  PathOf("t.txt"), {common::kUnixEpoch, after, before},
                  {Rigid3d(), Rigid3d({1., 2., 3.}, Eigen::Quaterniond(0., 1., 0., 0.)), Rigid3d()})
                  .ok());
  EXPECT_EQ(ContentOf("t.txt"),
            "0.0000000 0 0 0 0 0 0 1\n"
            "1234567890.0000001 1 2 3 1 0 0 0\n"
            "-0.5000000 0 0 0 0 0 0 1\n");
}

TEST_F(TrajectoryFilesTest, NoPosesGiveAnEmptyFile) {
  ASSERT_TRUE(WriteKittiPoses(PathOf("p.txt"), {}).ok());
  EXPECT_EQ(ContentOf("p.txt"), "");
  ASSERT_TRUE(WriteTumPoses(PathOf("t.txt"), {}, {}).ok());
  EXPECT_EQ(ContentOf("t.txt"), "");
}

TEST_F(TrajectoryFilesTest, PosesThatAreNotFiniteAreNotWritten) {
  const std::vector<Rigid3d> poses = {Rigid3d(), Rigid3d::Translation({0., NAN, 0.})};
  const std::vector<common::Time> times(2, common::kUnixEpoch);
  MakeFile("p.txt", "before");
  for (const absl::Status& status :
       {WriteKittiPoses(PathOf("p.txt"), poses), WriteTumPoses(PathOf("p.txt"), times, poses)}) {
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(status.message()), HasSubstr("p.txt: not written: pose 1 is not"));
    EXPECT_EQ(ContentOf("p.txt"), "before");
  }
}

TEST_F(TrajectoryFilesTest, WritingWhereNoDirectoryIsFails) {
  const absl::Status status = WriteKittiPoses(PathOf("none/p.txt"), {Rigid3d()});
  EXPECT_FALSE(status.ok());
  EXPECT_THAT(std::string(status.message()), HasSubstr("none"));
}

// Named so that it runs before other tests have started threads, which fork() does not like.
using TrajectoryFilesDeathTest = TrajectoryFilesTest;

TEST_F(TrajectoryFilesDeathTest, TumNeedsATimeForEachPose) {
  EXPECT_DEATH((void)WriteTumPoses(PathOf("t.txt"), {}, {Rigid3d()}), "times");
}

}  // namespace
}  // namespace cartographer::io
