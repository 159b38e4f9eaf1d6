// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_TESTING_TEST_SEQUENCE_H_
#define TEST_TESTING_TEST_SEQUENCE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cartographer/transform/rigid_transform.h"

namespace semantic_kiss_testing {

// A short drive down a made-up street, exact to the float: every scan sees the same points of road,
// sidewalks, facades, poles, trunks and parked cars (labels with SemanticKITTI's ids), within 25 m
// of the sensor, and a car that moves ahead (252). Some thousand points a scan.
struct TestStreet {
  int num_scans = 5;
  double step_m = 0.5;        // driven from scan to scan
  double turn_rad = 0.01;     // turned to the left from scan to scan
  uint32_t seed = 1;          // of the points on the surfaces
  double points_per_m2 = 2.;  // on the surfaces

  // Pose of the sensor at scan `index`; that of scan 0 is the identity.
  cartographer::transform::Rigid3d StreetFromSensor(int index) const;
};

// A scan as files carry it: rows of x, y, z, remission, and an id for each point.
struct RawScan {
  std::vector<float> rows;
  std::vector<uint32_t> ids;
  size_t num_points() const { return ids.size(); }
};
RawScan ScanStreet(const TestStreet& street, int index);

// How the certainty of a point's label (0.8 everywhere) is written.
enum class TestCertainties { kNone, kPerPoint, kPerClass };

// Which files a sequence has beside the scans.
struct TestSequenceFiles {
  std::string sequence = "00";
  bool labels = true;
  TestCertainties certainties = TestCertainties::kNone;
  bool times = true;         // 10 Hz, beginning at 0
  bool calibration = true;   // with TestCameraFromLidar()
  bool ground_truth = true;  // in poses/NN.txt
};

// Writes the drive under `directory` as SemanticKITTI does. CHECK-fails if that does not work.
void WriteTestSequence(const std::string& directory, const TestStreet& street,
                       const TestSequenceFiles& files = {});

// Tr of the calib.txt that is written.
cartographer::transform::Rigid3d TestCameraFromLidar();

}  // namespace semantic_kiss_testing

#endif  // TEST_TESTING_TEST_SEQUENCE_H_
