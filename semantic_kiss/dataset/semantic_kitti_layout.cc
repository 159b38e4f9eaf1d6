// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/semantic_kitti_layout.h"

#include <algorithm>
#include <filesystem>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/status.h"

namespace semantic_kiss::dataset {
namespace {

namespace fs = std::filesystem;

bool IsDirectory(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// The path if there is something, else empty.
std::string IfExists(const fs::path& path) { return Exists(path) ? path.string() : ""; }

std::string NamesIn(const fs::path& directory) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    if (IsDirectory(entry->path())) names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names.empty() ? "nothing" : absl::StrJoin(names, ", ");
}

absl::StatusOr<fs::path> FindSequence(const SemanticKittiLocation& location) {
  const fs::path directory(location.directory);
  if (!IsDirectory(directory)) {
    return absl::NotFoundError(
        absl::StrCat(location.directory, ": no such directory; give the one that holds sequences/",
                     location.sequence));
  }
  const fs::path sequences = directory / "sequences";
  if (!IsDirectory(sequences)) {
    return absl::NotFoundError(absl::StrCat(location.directory,
                                            ": has no directory sequences; scans are expected in ",
                                            "sequences/", location.sequence, "/velodyne"));
  }
  const fs::path sequence = sequences / location.sequence;
  if (location.sequence.empty() || !IsDirectory(sequence)) {
    return absl::NotFoundError(absl::StrCat(sequences.string(), ": has no sequence \"",
                                            location.sequence, "\" but ", NamesIn(sequences)));
  }
  if (!IsDirectory(sequence / "velodyne")) {
    return absl::NotFoundError(
        absl::StrCat(sequence.string(), ": has no directory velodyne with the scans"));
  }
  return sequence;
}

// A directory that the user named; `what` says what for.
absl::StatusOr<std::string> NamedDirectory(const fs::path& base, const std::string& name,
                                           absl::string_view what) {
  const fs::path path = base / name;  // `name` alone if it is absolute
  if (IsDirectory(path)) return path.string();
  return absl::NotFoundError(absl::StrCat(
      path.string(), ": no such directory for the ", what,
      fs::path(name).is_absolute() ? "" : "; give an absolute path if it is elsewhere"));
}

// The same for what comes scan by scan: an absolute path may also be the root of results laid out
// like the benchmark's.
absl::StatusOr<std::string> ResultDirectory(const SemanticKittiLocation& location,
                                            const fs::path& sequence, const std::string& name,
                                            absl::string_view what) {
  const fs::path result = fs::path(name) / "sequences" / location.sequence / "predictions";
  if (result.is_absolute() && IsDirectory(result)) return result.string();
  return NamedDirectory(sequence, name, what);
}

absl::Status FindLabels(const SemanticKittiLocation& location, const fs::path& sequence,
                        SemanticKittiLayout* layout) {
  if (location.labels_dir == kNoLabels) return absl::OkStatus();
  if (location.labels_dir.empty()) {
    layout->labels_dir = IfExists(sequence / "labels");
    return absl::OkStatus();
  }
  ASSIGN_OR_RETURN(layout->labels_dir,
                   ResultDirectory(location, sequence, location.labels_dir, "labels"));
  return absl::OkStatus();
}

absl::Status FindConfidences(const proto::DatasetOptions& options, SemanticKittiLayout* layout) {
  const std::string& name = options.confidences_dir();
  if (layout->labels_dir.empty() || name.empty()) return absl::OkStatus();
  const fs::path beside_labels = fs::path(layout->labels_dir).parent_path();
  if (!fs::path(name).is_absolute() && !Exists(beside_labels / name)) return absl::OkStatus();
  ASSIGN_OR_RETURN(layout->confidences_dir, NamedDirectory(beside_labels, name, "certainties"));
  return absl::OkStatus();
}

// KITTI's own ground truth is in poses/; what SemanticKITTI puts beside the scans is the estimate
// of another SLAM system, so it comes second.
absl::StatusOr<std::string> FindPoses(const SemanticKittiLocation& location,
                                      const fs::path& sequence) {
  if (!location.ground_truth_file.empty()) {
    if (Exists(location.ground_truth_file)) return location.ground_truth_file;
    return absl::NotFoundError(absl::StrCat(location.ground_truth_file,
                                            ": no such file; it was named as the ground truth"));
  }
  const std::string truth =
      IfExists(fs::path(location.directory) / "poses" / (location.sequence + ".txt"));
  return truth.empty() ? IfExists(sequence / "poses.txt") : truth;
}

void AddNotes(const proto::DatasetOptions& options, SemanticKittiLayout* layout) {
  std::vector<std::string>& notes = layout->notes;
  if (layout->labels_dir.empty()) {
    notes.push_back("no labels: every point is unlabeled");
  } else {
    notes.push_back(absl::StrCat("labels from ", layout->labels_dir));
    notes.push_back(layout->confidences_dir.empty()
                        ? "certainties of the labels from the label set"
                        : absl::StrCat("certainties from ", layout->confidences_dir));
  }
  if (!layout->moving_masks_dir.empty()) {
    notes.push_back(absl::StrCat("moving-object masks from ", layout->moving_masks_dir));
  }
  if (layout->times_file.empty()) {
    notes.push_back(absl::StrCat("no times.txt: ", options.assumed_rate_hz(), " Hz are assumed"));
  }
  notes.push_back(layout->poses_file.empty()
                      ? "no ground truth"
                      : absl::StrCat("ground truth from ", layout->poses_file));
}

}  // namespace

absl::StatusOr<SemanticKittiLayout> FindSemanticKittiFiles(const SemanticKittiLocation& location,
                                                           const proto::DatasetOptions& options) {
  ASSIGN_OR_RETURN(const fs::path sequence, FindSequence(location));
  SemanticKittiLayout layout;
  layout.velodyne_dir = (sequence / "velodyne").string();
  RETURN_IF_ERROR(FindLabels(location, sequence, &layout));
  RETURN_IF_ERROR(FindConfidences(options, &layout));
  if (!options.moving_masks_dir().empty()) {
    ASSIGN_OR_RETURN(
        layout.moving_masks_dir,
        ResultDirectory(location, sequence, options.moving_masks_dir(), "moving-object masks"));
  }
  layout.point_times_dir = IfExists(sequence / "point_times");
  layout.times_file = IfExists(sequence / "times.txt");
  layout.calib_file = IfExists(sequence / "calib.txt");
  ASSIGN_OR_RETURN(layout.poses_file, FindPoses(location, sequence));
  AddNotes(options, &layout);
  return layout;
}

}  // namespace semantic_kiss::dataset
