// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/semantic_kitti_source.h"

#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/common/time.h"
#include "cartographer/io/trajectory_files.h"
#include "glog/logging.h"
#include "semantic_kiss/dataset/certainty_file.h"
#include "semantic_kiss/dataset/file_buffer.h"
#include "semantic_kiss/dataset/label_file.h"
#include "semantic_kiss/dataset/point_file.h"
#include "semantic_kiss/dataset/scan_times.h"
#include "semantic_kiss/dataset/vertical_correction.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::common::FromUnixSeconds;
using cartographer::common::Time;
using cartographer::sensor::kUnlabeled;
using cartographer::sensor::LabeledPointCloud;
using cartographer::sensor::LabeledScan;
using cartographer::sensor::LabelSet;
using cartographer::transform::Rigid3d;

// What is known of a sequence once it is open.
struct Sequence {
  SemanticKittiLayout layout;
  std::vector<ScanFile> scans;
  std::vector<Time> times;  // one for each scan
  std::optional<Rigid3d> camera_from_sensor;
  std::optional<std::vector<Rigid3d>> ground_truth;  // one for each scan
  LabelSet labels;
  CertaintyReader certainties;
  std::optional<MovingVariants> moving_variants;
  double vertical_correction_rad = 0.;
};

class SemanticKittiSource : public ScanSource {
 public:
  explicit SemanticKittiSource(Sequence sequence) : sequence_(std::move(sequence)) {}

  int size() const override { return static_cast<int>(sequence_.scans.size()); }
  absl::StatusOr<LabeledScan> Read(int index) override;
  const LabelSet& labels() const override { return sequence_.labels; }
  const std::optional<std::vector<Rigid3d>>& ground_truth() const override {
    return sequence_.ground_truth;
  }
  const std::optional<Rigid3d>& camera_from_sensor() const override {
    return sequence_.camera_from_sensor;
  }
  const UnknownLabelIds& unknown_label_ids() const override { return unknown_ids_; }
  const std::vector<std::string>& notes() const override { return sequence_.layout.notes; }

 private:
  absl::Status ReadPositions(const ScanFile& file, LabeledPointCloud* cloud);
  absl::Status ReadClasses(const ScanFile& file, LabeledPointCloud* cloud,
                           UnknownLabelIds* unknown_ids);
  absl::Status ReadCertainties(const ScanFile& file, LabeledPointCloud* cloud);

  const Sequence sequence_;
  FileBuffer buffer_;
  UnknownLabelIds unknown_ids_;
};

std::string FileOf(const std::string& directory, const ScanFile& scan, const char* extension) {
  return absl::StrCat(directory, "/", scan.stem, extension);
}

absl::StatusOr<LabeledScan> SemanticKittiSource::Read(int index) {
  CHECK_GE(index, 0);
  CHECK_LT(index, size());
  const ScanFile& file = sequence_.scans[index];
  LabeledScan scan;
  scan.index = file.number;
  scan.time = sequence_.times[index];
  UnknownLabelIds unknown_ids;
  RETURN_IF_ERROR(ReadPositions(file, &scan.points));
  RETURN_IF_ERROR(ReadClasses(file, &scan.points, &unknown_ids));
  RETURN_IF_ERROR(ReadCertainties(file, &scan.points));
  for (const auto& [id, count] : unknown_ids) unknown_ids_[id] += count;
  return scan;
}

absl::Status SemanticKittiSource::ReadPositions(const ScanFile& file, LabeledPointCloud* cloud) {
  RETURN_IF_ERROR(ReadPoints(FileOf(sequence_.layout.velodyne_dir, file, ".bin"), &buffer_, cloud));
  if (sequence_.vertical_correction_rad != 0.) {
    RaiseElevation(sequence_.vertical_correction_rad, &cloud->positions);
  }
  if (sequence_.layout.point_times_dir.empty()) return absl::OkStatus();
  return ReadPointTimes(FileOf(sequence_.layout.point_times_dir, file, ".bin"), cloud->size(),
                        &buffer_, &cloud->times);
}

absl::Status SemanticKittiSource::ReadClasses(const ScanFile& file, LabeledPointCloud* cloud,
                                              UnknownLabelIds* unknown_ids) {
  if (sequence_.layout.labels_dir.empty()) {
    cloud->labels.assign(cloud->size(), kUnlabeled);
  } else {
    const std::string path = FileOf(sequence_.layout.labels_dir, file, ".label");
    RETURN_IF_ERROR(
        ReadLabels({path, cloud->size()}, sequence_.labels, &buffer_, &cloud->labels, unknown_ids));
  }
  if (!sequence_.moving_variants.has_value()) return absl::OkStatus();
  return sequence_.moving_variants->ApplyMask(
      FileOf(sequence_.layout.moving_masks_dir, file, ".label"), &buffer_, &cloud->labels);
}

absl::Status SemanticKittiSource::ReadCertainties(const ScanFile& file, LabeledPointCloud* cloud) {
  if (sequence_.layout.confidences_dir.empty()) {
    sequence_.certainties.FillDefaults(cloud->labels, &cloud->certainties);
    return absl::OkStatus();
  }
  return sequence_.certainties.Read(FileOf(sequence_.layout.confidences_dir, file, ".conf"),
                                    cloud->labels, &buffer_, &cloud->certainties);
}

// The entry for each of `scans` out of a file with a line for every number from 0.
template <typename T>
absl::StatusOr<std::vector<T>> TakeLines(const std::string& path, const std::vector<T>& lines,
                                         const std::vector<ScanFile>& scans) {
  if (lines.size() <= scans.back().number) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": has ", lines.size(), " lines, but the scans go to ",
                     scans.back().stem, ".bin; a line for every scan from number 0 on is needed"));
  }
  const auto first = lines.begin() + scans.front().number;
  return std::vector<T>(first, first + scans.size());
}

absl::Status LoadTimes(const proto::DatasetOptions& options, Sequence* sequence) {
  if (sequence->layout.times_file.empty()) {
    for (const ScanFile& scan : sequence->scans) {
      sequence->times.push_back(FromUnixSeconds(scan.number / options.assumed_rate_hz()));
    }
    return absl::OkStatus();
  }
  ASSIGN_OR_RETURN(const std::vector<Time> times, ReadScanTimes(sequence->layout.times_file));
  ASSIGN_OR_RETURN(sequence->times, TakeLines(sequence->layout.times_file, times, sequence->scans));
  return absl::OkStatus();
}

absl::Status LoadCalibration(Sequence* sequence) {
  absl::StatusOr<Rigid3d> camera_from_sensor =
      absl::NotFoundError("no calib.txt");  // as if it had no Tr
  if (!sequence->layout.calib_file.empty()) {
    camera_from_sensor = cartographer::io::ReadKittiCalibration(sequence->layout.calib_file);
  }
  if (camera_from_sensor.ok()) {
    sequence->camera_from_sensor = *camera_from_sensor;
  } else if (absl::IsNotFound(camera_from_sensor.status())) {
    sequence->layout.notes.push_back("no Tr in calib.txt: poses are taken as the lidar's own");
  } else {
    return camera_from_sensor.status();
  }
  return absl::OkStatus();
}

absl::Status LoadGroundTruth(Sequence* sequence) {
  const std::string& path = sequence->layout.poses_file;
  if (path.empty()) return absl::OkStatus();
  ASSIGN_OR_RETURN(std::vector<Rigid3d> poses, cartographer::io::ReadKittiPoses(path));
  if (sequence->camera_from_sensor.has_value()) {
    poses = cartographer::io::PosesOfOtherBody(poses, sequence->camera_from_sensor->inverse());
  }
  ASSIGN_OR_RETURN(sequence->ground_truth, TakeLines(path, poses, sequence->scans));
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::unique_ptr<ScanSource>> OpenSemanticKitti(const SemanticKittiLocation& location,
                                                              const ScanRange& range,
                                                              const proto::DatasetOptions& options,
                                                              const LabelSet& labels) {
  Sequence sequence;
  sequence.labels = labels;
  sequence.vertical_correction_rad = options.vertical_correction_deg() * M_PI / 180.;
  ASSIGN_OR_RETURN(sequence.layout, FindSemanticKittiFiles(location, options));
  ASSIGN_OR_RETURN(sequence.scans, ListScanFiles(sequence.layout.velodyne_dir, range));
  sequence.certainties = CertaintyReader(
      labels, {options.confidence_columns().begin(), options.confidence_columns().end()});
  if (!sequence.layout.moving_masks_dir.empty()) {
    ASSIGN_OR_RETURN(sequence.moving_variants, MovingVariants::Create(labels));
  }
  RETURN_IF_ERROR(LoadTimes(options, &sequence));
  RETURN_IF_ERROR(LoadCalibration(&sequence));
  RETURN_IF_ERROR(LoadGroundTruth(&sequence));
  return std::make_unique<SemanticKittiSource>(std::move(sequence));
}

}  // namespace semantic_kiss::dataset
