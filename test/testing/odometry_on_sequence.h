// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_TESTING_ODOMETRY_ON_SEQUENCE_H_
#define TEST_TESTING_ODOMETRY_ON_SEQUENCE_H_

#include <string>
#include <vector>

#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "semantic_kiss/proto/semantic_kiss_options.pb.h"

namespace semantic_kiss_testing {

// The shipped options of the builder "semantic_kiss", after the Lua statements `overrides`, which
// may name them as `options`: "options.odometry.mode = 'kiss_icp'". CHECK-fails on errors.
semantic_kiss::proto::SemanticKissOptions ShippedOptions(const std::string& overrides = "");

// The shipped label set of SemanticKITTI.
cartographer::sensor::LabelSet ShippedLabels();

// All scans of sequence 00 of a directory in SemanticKITTI's format, with the correction that
// KITTI's scans need. CHECK-fails on errors.
std::vector<cartographer::sensor::LabeledScan> ReadScans(const std::string& directory);

}  // namespace semantic_kiss_testing

#endif  // TEST_TESTING_ODOMETRY_ON_SEQUENCE_H_
