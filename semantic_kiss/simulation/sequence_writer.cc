// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/sequence_writer.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "cartographer/io/trajectory_files.h"
#include "semantic_kiss/dataset/scan_writer.h"
#include "semantic_kiss/dataset/sequence_directory.h"
#include "semantic_kiss/simulation/material.h"
#include "semantic_kiss/simulation/recorded_route.h"

namespace semantic_kiss::simulation {
namespace {

using cartographer::io::WriteFileAtomically;
using cartographer::transform::Rigid3d;

constexpr char kManifest[] = "simulation.lua";

// As in SemanticKITTI, the upper 16 bits tell the individuals of countable classes apart.
uint32_t LabelWord(const SimulatedPoint& point) {
  const uint32_t instance = IsMovable(point.label) ? point.object % 0xfffe + 1 : 0;
  return instance << 16 | point.label;
}

std::string CalibrationRows() {
  const Eigen::Matrix<double, 3, 4> tr = CameraFromLidar().Matrix();
  std::string rows;
  for (int camera = 0; camera < 4; ++camera) {
    absl::StrAppendFormat(&rows, "P%d: 707.0912 0 601.8873 0 0 707.0912 183.1104 0 0 0 1 0\n",
                          camera);
  }
  absl::StrAppend(&rows, "Tr:");
  for (int i = 0; i < 12; ++i) absl::StrAppendFormat(&rows, " %.12e", tr(i / 4, i % 4));
  absl::StrAppend(&rows, "\n");
  return rows;
}

}  // namespace

absl::StatusOr<SequenceWriter> SequenceWriter::Open(const std::string& directory,
                                                    const std::string& sequence,
                                                    const ScanColumns& columns,
                                                    absl::string_view manifest) {
  ASSIGN_OR_RETURN(const std::string path_of_sequence,
                   dataset::SequenceDirectory(directory, sequence));
  SequenceWriter writer(path_of_sequence, columns);
  RETURN_IF_ERROR(dataset::MakeDirectory(absl::StrCat(writer.directory_, "/velodyne")));
  const std::string path = absl::StrCat(writer.directory_, "/", kManifest);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    const std::string scans = absl::StrCat(writer.directory_, "/velodyne");
    if (!std::filesystem::is_empty(scans)) {
      return absl::FailedPreconditionError(absl::StrCat(
          scans, ": scans that this command did not write are here; choose another directory"));
    }
    RETURN_IF_ERROR(WriteFileAtomically(path, manifest));
    return writer;
  }
  const std::string present{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (present != manifest) {
    return absl::FailedPreconditionError(
        absl::StrCat(path,
                     ": scans made with other options are here; remove them or choose "
                     "another directory or sequence"));
  }
  return writer;
}

bool SequenceWriter::IsComplete(int scan) const {
  return std::filesystem::exists(dataset::PointFileOf(directory_, scan));
}

absl::Status SequenceWriter::WriteScan(int scan, const SimulatedScan& points) const {
  dataset::ScanFiles files;
  files.label_words.emplace();
  if (columns_.certainties) files.certainties.emplace();
  if (columns_.times) files.times_s.emplace();
  for (const SimulatedPoint& point : points) {
    const Eigen::Vector3f& position = point.position;
    files.points.push_back({position.x(), position.y(), position.z(), point.remission});
    files.label_words->push_back(LabelWord(point));
    if (columns_.certainties) files.certainties->push_back(point.certainty);
    if (columns_.times) files.times_s->push_back(point.time_s);
  }
  return dataset::WriteScanFiles(directory_, scan, files);
}

absl::Status SequenceWriter::WriteDrive(const std::vector<Rigid3d>& start_from_lidar,
                                        double scan_rate_hz) const {
  RETURN_IF_ERROR(WriteFileAtomically(absl::StrCat(directory_, "/calib.txt"), CalibrationRows()));
  std::string times;
  for (size_t i = 0; i < start_from_lidar.size(); ++i) {
    absl::StrAppendFormat(&times, "%.6e\n", i / scan_rate_hz);
  }
  RETURN_IF_ERROR(WriteFileAtomically(absl::StrCat(directory_, "/times.txt"), times));
  return cartographer::io::WriteKittiPoses(
      absl::StrCat(directory_, "/poses.txt"),
      cartographer::io::PosesOfOtherBody(start_from_lidar, CameraFromLidar()));
}

}  // namespace semantic_kiss::simulation
