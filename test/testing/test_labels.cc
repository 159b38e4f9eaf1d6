// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/testing/test_labels.h"

#include <string>

#include "glog/logging.h"

namespace semantic_kiss_testing {
namespace {

struct ClassRow {
  int id;
  const char* name;
  const char* role;  // "": none
};

constexpr ClassRow kClasses[] = {{0, "unlabeled", "unlabeled"},
                                 {1, "outlier", "unlabeled"},
                                 {10, "car", "movable"},
                                 {11, "bicycle", "movable"},
                                 {18, "truck", "movable"},
                                 {20, "other-vehicle", "movable"},
                                 {30, "person", "movable"},
                                 {40, "road", "ground"},
                                 {48, "sidewalk", "ground"},
                                 {50, "building", ""},
                                 {60, "lane-marking", ""},
                                 {70, "vegetation", ""},
                                 {71, "trunk", ""},
                                 {80, "pole", "critical"},
                                 {81, "traffic-sign", "critical"},
                                 {252, "moving-car", "moving"},
                                 {254, "moving-person", "moving"},
                                 {255, "moving-motorcyclist", "moving"}};

}  // namespace

cartographer::sensor::proto::LabelSet SomeKittiLabelsDeclaration() {
  cartographer::sensor::proto::LabelSet declaration;
  declaration.set_name("some_kitti_labels");
  declaration.set_default_certainty(0.5);
  for (const ClassRow& row : kClasses) {
    auto* const entry = declaration.add_classes();
    entry->set_id(row.id);
    entry->set_name(row.name);
    for (const int component : {row.id % 256, 100, 200}) entry->add_color(component);
    if (*row.role != '\0') entry->add_roles(row.role);
    if (row.name == std::string("lane-marking")) entry->set_merged_into("road");
    if (row.name == std::string("road")) entry->set_certainty(0.9);
  }
  return declaration;
}

cartographer::sensor::LabelSet SomeKittiLabels() {
  auto labels = cartographer::sensor::LabelSet::Create(SomeKittiLabelsDeclaration());
  CHECK(labels.ok()) << labels.status();
  return *std::move(labels);
}

}  // namespace semantic_kiss_testing
