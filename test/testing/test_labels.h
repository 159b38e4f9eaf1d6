// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_TESTING_TEST_LABELS_H_
#define TEST_TESTING_TEST_LABELS_H_

#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/proto/label_set.pb.h"

namespace semantic_kiss_testing {

// An excerpt of SemanticKITTI's label set, enough for every rule to have a class that it applies
// to. Default certainty 0.5, but 0.9 for roads:
//   unlabeled 0, outlier 1 (both unlabeled), car 10 (movable), bicycle 11 (movable), truck 18
//   (movable), other-vehicle 20 (movable), person 30 (movable), road 40 (ground), lane-marking 60
//   (merged into road), sidewalk 48 (ground), building 50, vegetation 70, trunk 71, pole 80
//   (critical), traffic-sign 81 (critical), moving-car 252, moving-person 254,
//   moving-motorcyclist 255 (all three moving).
cartographer::sensor::LabelSet SomeKittiLabels();

// What SomeKittiLabels() is made of, to be changed.
cartographer::sensor::proto::LabelSet SomeKittiLabelsDeclaration();

}  // namespace semantic_kiss_testing

#endif  // TEST_TESTING_TEST_LABELS_H_
