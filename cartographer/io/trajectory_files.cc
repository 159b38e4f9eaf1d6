// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/trajectory_files.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_split.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

using transform::Rigid3d;

constexpr int kNumbersPerPose = 12;
constexpr int64_t kTicksPerSecond = 10'000'000;

absl::StatusOr<std::string> ReadText(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return absl::NotFoundError(absl::StrCat(path, ": no such file; check the path"));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, ignored)) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": cannot be read; give a text file with read permission"));
  }
  return std::string(std::istreambuf_iterator<char>(file), {});
}

absl::StatusOr<double> ParseNumber(absl::string_view text) {
  double number;
  if (!absl::SimpleAtod(text, &number) || !std::isfinite(number)) {
    return absl::InvalidArgumentError(absl::StrCat("`", absl::CHexEscape(text.substr(0, 40)),
                                                   "` is not a finite number; correct the line"));
  }
  return number;
}

absl::StatusOr<Rigid3d> ParsePose(absl::string_view line) {
  const std::vector<absl::string_view> words =
      absl::StrSplit(line, absl::ByAnyChar(" \t\r"), absl::SkipEmpty());
  if (words.size() != kNumbersPerPose) {
    return absl::InvalidArgumentError(
        absl::StrCat("has ", words.size(),
                     " numbers; a pose in KITTI's format has 12, the upper 3 x 4 part of its "
                     "matrix row by row"));
  }
  Eigen::Matrix<double, 3, 4> matrix;
  for (int i = 0; i < kNumbersPerPose; ++i) {
    ASSIGN_OR_RETURN(matrix(i / 4, i % 4), ParseNumber(words[i]));
  }
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  const double deviation =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(deviation <= kRotationTolerance) || rotation.determinant() < 0.) {
    return absl::InvalidArgumentError(absl::StrFormat(
        "the left 3 x 3 block is no rotation (determinant %g, R^T R is %g from the identity, at "
        "most %g is accepted); write world_from_body row by row, with six decimals or more",
        rotation.determinant(), deviation, kRotationTolerance));
  }
  return Rigid3d::FromMatrix(matrix);
}

absl::Status CheckFinite(const std::string& path, const std::vector<Rigid3d>& poses) {
  for (size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i].IsFinite()) {
      return absl::InvalidArgumentError(absl::StrCat(path, ": not written: pose ", i,
                                                     " is not finite: ", poses[i].DebugString()));
    }
  }
  return absl::OkStatus();
}

std::string UnixSeconds(common::Time time) {
  const int64_t ticks = (time - common::kUnixEpoch).count();
  return absl::StrFormat("%s%d.%07d", ticks < 0 ? "-" : "", std::abs(ticks / kTicksPerSecond),
                         std::abs(ticks % kTicksPerSecond));
}

}  // namespace

absl::StatusOr<std::vector<Rigid3d>> ReadKittiPoses(const std::string& path) {
  ASSIGN_OR_RETURN(const std::string text, ReadText(path));
  const absl::string_view content = absl::StripTrailingAsciiWhitespace(text);
  if (content.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": has no poses; give a file with 12 numbers a line"));
  }
  std::vector<Rigid3d> poses;
  for (const absl::string_view line : absl::StrSplit(content, '\n')) {
    absl::StatusOr<Rigid3d> pose = ParsePose(line);
    if (!pose.ok()) {
      return common::AddContext(pose.status(), absl::StrCat(path, ":", poses.size() + 1));
    }
    poses.push_back(*pose);
  }
  return poses;
}

absl::StatusOr<Rigid3d> ReadKittiCalibration(const std::string& path) {
  constexpr absl::string_view kKey = "Tr:";
  ASSIGN_OR_RETURN(const std::string text, ReadText(path));
  int line_number = 0;
  for (absl::string_view line : absl::StrSplit(text, '\n')) {
    ++line_number;
    line = absl::StripLeadingAsciiWhitespace(line);
    if (line.substr(0, kKey.size()) != kKey) continue;
    absl::StatusOr<Rigid3d> camera_from_lidar = ParsePose(line.substr(kKey.size()));
    if (camera_from_lidar.ok()) return camera_from_lidar;
    return common::AddContext(camera_from_lidar.status(), absl::StrCat(path, ":", line_number));
  }
  return absl::NotFoundError(
      absl::StrCat(path, ": has no row `Tr:`; add camera_from_lidar as `Tr:` and 12 numbers"));
}

std::vector<Rigid3d> PosesOfOtherBody(const std::vector<Rigid3d>& a_poses,
                                      const Rigid3d& b_from_a) {
  const Rigid3d a_from_b = b_from_a.inverse();
  std::vector<Rigid3d> b_poses;
  b_poses.reserve(a_poses.size());
  for (const Rigid3d& pose : a_poses) b_poses.push_back(b_from_a * pose * a_from_b);
  return b_poses;
}

absl::Status WriteKittiPoses(const Destination& destination, const std::vector<Rigid3d>& poses) {
  RETURN_IF_ERROR(CheckFinite(destination.path, poses));
  std::string text;
  for (const Rigid3d& pose : poses) {
    const Eigen::Matrix<double, 3, 4> matrix = pose.Matrix();
    for (int i = 0; i < kNumbersPerPose; ++i) {
      absl::StrAppendFormat(&text, "%.17g%c", matrix(i / 4, i % 4),
                            i + 1 == kNumbersPerPose ? '\n' : ' ');
    }
  }
  return WriteFileAtomically(destination, text);
}

absl::Status WriteTumPoses(const Destination& destination, const std::vector<common::Time>& times,
                           const std::vector<Rigid3d>& poses) {
  CHECK_EQ(times.size(), poses.size());
  RETURN_IF_ERROR(CheckFinite(destination.path, poses));
  std::string text;
  for (size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d& t = poses[i].translation();
    const Eigen::Quaterniond& q = poses[i].rotation();
    absl::StrAppendFormat(&text, "%s %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n",
                          UnixSeconds(times[i]), t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  return WriteFileAtomically(destination, text);
}

}  // namespace cartographer::io
