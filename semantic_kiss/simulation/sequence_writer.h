// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_SEQUENCE_WRITER_H_
#define SEMANTIC_KISS_SIMULATION_SEQUENCE_WRITER_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"
#include "cartographer/transform/rigid_transform.h"
#include "semantic_kiss/simulation/scanner.h"

namespace semantic_kiss::simulation {

// Which columns a scan's files have.
struct ScanColumns {
  bool certainties = false;  // confidences/NNNNNN.conf
  bool times = false;        // point_times/NNNNNN.bin
};

// Writes one sequence in SemanticKITTI's layout below DIR/sequences/NN. Every file appears whole or
// not at all, a scan's points last: where they are, the scan is complete.
class SequenceWriter {
 public:
  // Makes the directories. `manifest` describes how the scans are made; if a manifest of another
  // content is there, scans of two kinds would mix: FailedPrecondition.
  static absl::StatusOr<SequenceWriter> Open(const std::string& directory,
                                             const std::string& sequence,
                                             const ScanColumns& columns,
                                             absl::string_view manifest);

  bool IsComplete(int scan) const;
  absl::Status WriteScan(int scan, const SimulatedScan& points) const;

  // calib.txt, times.txt and poses.txt (of the camera, in its frame at the start); written once all
  // scans are there.
  absl::Status WriteDrive(const std::vector<cartographer::transform::Rigid3d>& start_from_lidar,
                          double scan_rate_hz) const;

  const std::string& directory() const { return directory_; }

 private:
  SequenceWriter(std::string directory, const ScanColumns& columns)
      : directory_(std::move(directory)), columns_(columns) {}

  std::string directory_;  // DIR/sequences/NN
  ScanColumns columns_;
};

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_SEQUENCE_WRITER_H_
