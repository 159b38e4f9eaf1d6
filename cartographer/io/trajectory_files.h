// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_TRAJECTORY_FILES_H_
#define CARTOGRAPHER_IO_TRAJECTORY_FILES_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cartographer/common/time.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/transform/rigid_transform.h"

// Trajectories as text, in the two formats that everyone reads:
//   KITTI  a pose a line: the upper 3 x 4 part of world_from_body, row by row, 12 numbers [m];
//          the line's index is the scan's. The benchmark's own poses are of the left camera.
//   TUM    a pose a line: time [s] x y z [m] qx qy qz qw.
namespace cartographer::io {

// Farthest that an entry of R^T R may be from the identity's in a rotation that is read: files
// with four decimals pass, a scale or a column too many does not.
inline constexpr double kRotationTolerance = 1e-3;

// Reads poses in KITTI's format, at least one. The rotations are made orthonormal.
// Errors, naming file and line: NotFound if there is no such file; InvalidArgument for a line that
// is not 12 finite numbers, for a left 3 x 3 block that is no rotation, for a file without poses.
absl::StatusOr<std::vector<transform::Rigid3d>> ReadKittiPoses(const std::string& path);

// Reads camera_from_lidar, the row `Tr:` of a KITTI calib.txt; other rows are ignored.
// NotFound if there is no such file or no such row (poses are then the lidar's own);
// InvalidArgument, naming file and line, if the row is malformed.
absl::StatusOr<transform::Rigid3d> ReadKittiCalibration(const std::string& path);

// The same drive told by another body on the same vehicle: result[i] = b_from_a * a_poses[i] *
// b_from_a^-1. With camera_from_lidar, lidar poses become the camera poses of KITTI's files; with
// its inverse they come back.
std::vector<transform::Rigid3d> PosesOfOtherBody(const std::vector<transform::Rigid3d>& a_poses,
                                                 const transform::Rigid3d& b_from_a);

// Write a trajectory; an existing file is replaced atomically, or kept if writing fails. Numbers
// have 17 significant digits, so that reading them gives the same doubles. A pose that is not
// finite gives InvalidArgument naming its index, and no file.
absl::Status WriteKittiPoses(const Destination& destination,
                             const std::vector<transform::Rigid3d>& poses);
// Times are seconds since the Unix epoch with all their seven decimals. Needs as many times as
// poses (CHECKed).
absl::Status WriteTumPoses(const Destination& destination, const std::vector<common::Time>& times,
                           const std::vector<transform::Rigid3d>& poses);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_TRAJECTORY_FILES_H_
