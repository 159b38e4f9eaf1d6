// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/scan_writer.h"

#include <filesystem>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"
#include "semantic_kiss/dataset/sequence_directory.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::common::Time;

std::string PathOf(const std::string& sequence_directory, const char* folder, int scan,
                   const char* ending) {
  return absl::StrFormat("%s/%s/%06d.%s", sequence_directory, folder, scan, ending);
}

template <typename Number>
absl::Status WriteNumbers(const std::string& path, const std::vector<Number>& numbers) {
  RETURN_IF_ERROR(MakeDirectory(std::filesystem::path(path).parent_path()));
  return cartographer::io::WriteFileAtomically(
      path, absl::string_view(reinterpret_cast<const char*>(numbers.data()),
                              numbers.size() * sizeof(Number)));
}

}  // namespace

ScanFiles FilesOf(const cartographer::sensor::LabeledPointCloud& cloud,
                  const cartographer::sensor::LabelSet& labels) {
  ScanFiles files;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& position = cloud.positions[i];
    files.points.push_back({position.x(), position.y(), position.z(),
                            cloud.intensities.empty() ? 0.f : cloud.intensities[i]});
  }
  if (!cloud.times.empty()) files.times_s = cloud.times;
  if (labels.size() == 1) return files;
  files.label_words.emplace();
  for (const cartographer::sensor::Label label : cloud.labels) {
    files.label_words->push_back(labels.FileId(label));
  }
  files.certainties = cloud.certainties;
  return files;
}

std::string PointFileOf(const std::string& sequence_directory, int scan) {
  return PathOf(sequence_directory, "velodyne", scan, "bin");
}

absl::Status WriteScanFiles(const std::string& sequence_directory, int scan,
                            const ScanFiles& files) {
  const auto path_of = [&](const char* folder, const char* ending) {
    return PathOf(sequence_directory, folder, scan, ending);
  };
  if (files.label_words.has_value()) {
    RETURN_IF_ERROR(WriteNumbers(path_of("labels", "label"), *files.label_words));
  }
  if (files.certainties.has_value()) {
    RETURN_IF_ERROR(WriteNumbers(path_of("confidences", "conf"), *files.certainties));
  }
  if (files.times_s.has_value()) {
    RETURN_IF_ERROR(WriteNumbers(path_of("point_times", "bin"), *files.times_s));
  }
  return WriteNumbers(PointFileOf(sequence_directory, scan), files.points);
}

absl::Status WriteScanTimes(const std::string& sequence_directory, const std::vector<Time>& times) {
  std::string rows;
  for (const Time time : times) {
    absl::StrAppendFormat(&rows, "%.7f\n", cartographer::common::ToUnixSeconds(time));
  }
  return cartographer::io::WriteFileAtomically(absl::StrCat(sequence_directory, "/times.txt"),
                                               rows);
}

}  // namespace semantic_kiss::dataset
