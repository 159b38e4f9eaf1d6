// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/simulation.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/simulation/recorded_route.h"
#include "tbb/global_control.h"
#include "tbb/task_arena.h"
#include "test/semantic_kiss/simulation/small_drive.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::simulation {
namespace {

using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;

bool Continue(int) { return true; }

// Contents of all files below a directory, by their names there.
std::map<std::string, std::string> FilesBelow(const std::string& directory) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    if (!entry.is_regular_file()) continue;
    files[std::filesystem::relative(entry.path(), directory).string()] =
        ReadText(entry.path().string());
  }
  return files;
}

std::map<std::string, std::string> WrittenWith(int threads, const std::string& overrides) {
  const TemporaryDirectory directory;
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena arena(threads);
  arena.execute([&] {
    const auto drive = SmallDrive(overrides);
    EXPECT_TRUE(WriteSequence(*drive, {directory.path(), "07", 20}, Continue).ok());
  });
  return FilesBelow(directory.path());
}

TEST(SimulationTest, BytesDoNotDependOnThreads) {
  const std::string overrides = "options.raw = true options.label_noise.share = 0.1";
  const auto one = WrittenWith(1, overrides), eight = WrittenWith(8, overrides);
  EXPECT_EQ(one.size(), 4u * 20 + 4);
  ASSERT_EQ(one.size(), eight.size());
  for (const auto& [name, bytes] : one) EXPECT_TRUE(eight.at(name) == bytes) << name;
}

TEST(SimulationTest, FilesAreLaidOutAsSemanticKittis) {
  const auto files = WrittenWith(2, "");
  const auto& points = files.at("sequences/07/velodyne/000019.bin");
  EXPECT_EQ(points.size() % 16, 0u);
  EXPECT_EQ(files.at("sequences/07/labels/000019.label").size(), points.size() / 4);
  EXPECT_EQ(files.count("sequences/07/confidences/000019.conf"), 0u);
  EXPECT_EQ(files.count("sequences/07/point_times/000019.bin"), 0u);
  EXPECT_EQ(files.count("sequences/07/velodyne/000020.bin"), 0u);
  const std::string& times = files.at("sequences/07/times.txt");
  EXPECT_EQ(std::count(times.begin(), times.end(), '\n'), 20);
}

TEST(SimulationTest, WrittenPosesAreTheTrueOnes) {
  const TemporaryDirectory directory;
  const auto drive = SmallDrive();
  ASSERT_TRUE(WriteSequence(*drive, {directory.path(), "00", 12}, Continue).ok());
  const auto poses = cartographer::io::ReadKittiPoses(directory / "sequences/00/poses.txt");
  const auto camera_from_lidar =
      cartographer::io::ReadKittiCalibration(directory / "sequences/00/calib.txt");
  ASSERT_TRUE(poses.ok() && camera_from_lidar.ok());
  ASSERT_EQ(poses->size(), 12u);
  const auto lidar_poses = cartographer::io::PosesOfOtherBody(*poses, camera_from_lidar->inverse());
  for (int i = 0; i < 12; ++i) {
    const auto expected = drive->world_from_lidar()[0].inverse() * drive->world_from_lidar()[i];
    EXPECT_NEAR((lidar_poses[i].translation() - expected.translation()).norm(), 0., 1e-9);
    EXPECT_NEAR(RotationAngle(lidar_poses[i].inverse() * expected), 0., 1e-7);
  }
}

TEST(SimulationTest, GoesOnWhereItStopped) {
  const TemporaryDirectory directory;
  const auto drive = SmallDrive();
  const WriteRequest request{directory.path(), "00", 40};
  const absl::Status stopped = WriteSequence(*drive, request, [](int) { return false; });
  EXPECT_EQ(stopped.code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(stopped.message(), "after 16 of 40 scans; the same command goes on from there");
  const std::string present = directory / "sequences/00/velodyne/000003.bin";
  const std::string missing = directory / "sequences/00/velodyne/000005.bin";
  const std::string bytes = ReadText(missing);
  WriteText(present, "kept as it is");
  std::filesystem::remove(missing);
  ASSERT_TRUE(WriteSequence(*drive, request, Continue).ok());
  EXPECT_EQ(ReadText(present), "kept as it is");
  EXPECT_TRUE(ReadText(missing) == bytes);
}

TEST(SimulationTest, DoesNotMixDrives) {
  const TemporaryDirectory directory;
  ASSERT_TRUE(WriteSequence(*SmallDrive(), {directory.path(), "00", 2}, Continue).ok());
  const absl::Status mixed =
      WriteSequence(*SmallDrive("options.seed = 2"), {directory.path(), "00", 2}, Continue);
  EXPECT_EQ(mixed.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_EQ(mixed.message(), directory / "sequences/00/simulation.lua" +
                                 ": scans made with other options are here; remove them or choose "
                                 "another directory or sequence");
  WriteText(directory / "sequences/01/velodyne/000000.bin", "foreign");
  const absl::Status foreign = WriteSequence(*SmallDrive(), {directory.path(), "01", 2}, Continue);
  EXPECT_EQ(foreign.message(),
            directory / "sequences/01/velodyne" +
                ": scans that this command did not write are here; choose another directory");
}

TEST(SimulationTest, RecordedRoutesAreDriven) {
  const TemporaryDirectory directory;
  // The camera goes straight ahead, its z axis, climbing 5 m in 100 m.
  std::string rows;
  for (int i = 0; i <= 100; ++i) {
    rows += "1 0 0 0 0 1 0 " + std::to_string(-0.05 * i) + " 0 0 1 " + std::to_string(i) + "\n";
  }
  WriteText(directory / "poses.txt", rows);
  const auto drive = SmallDrive("options.route.kind = 'recorded' options.route.poses_file = '" +
                                directory / "poses.txt" + "'");
  ASSERT_EQ(drive->num_scans(), 101);
  EXPECT_NEAR(drive->length_m(), 100., 0.1);
  const auto& poses = drive->world_from_lidar();
  EXPECT_NEAR((poses[60].translation() - poses[40].translation()).z(), 1., 0.4);
  EXPECT_NEAR((poses[60].translation() - poses[40].translation()).x(), 20., 0.1);
}

TEST(SimulationTest, BadPosesFilesAreNamed) {
  const TemporaryDirectory directory;
  proto::SimulationOptions options = SmallOptions("options.route.kind = 'recorded'");
  options.mutable_route()->set_poses_file(directory / "none.txt");
  EXPECT_EQ(Simulation::Create(options).status().code(), absl::StatusCode::kNotFound);
  WriteText(directory / "standing.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 0\n");
  options.mutable_route()->set_poses_file(directory / "standing.txt");
  EXPECT_EQ(Simulation::Create(options).status().message(),
            directory / "standing.txt" +
                ": 2 poses that move less than 2 m make no route; give a longer drive");
}

}  // namespace
}  // namespace semantic_kiss::simulation
