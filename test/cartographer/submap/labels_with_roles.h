// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_SUBMAP_LABELS_WITH_ROLES_H_
#define TEST_CARTOGRAPHER_SUBMAP_LABELS_WITH_ROLES_H_

#include <string>
#include <utility>
#include <vector>

#include "cartographer/sensor/label_set.h"
#include "glog/logging.h"

namespace cartographer::submap {

// A label set of classes that are no more than a name and a role ("": none); the first one has the
// role `unlabeled`.
inline sensor::LabelSet LabelsWithRoles(
    const std::vector<std::pair<std::string, std::string>>& classes) {
  sensor::proto::LabelSet declaration;
  declaration.set_name("test");
  declaration.set_default_certainty(1.);
  for (const auto& [name, role] : classes) {
    auto* const label_class = declaration.add_classes();
    label_class->set_id(declaration.classes_size() - 1);
    label_class->set_name(name);
    for (int i = 0; i < 3; ++i) label_class->add_color(100);
    if (!role.empty()) label_class->add_roles(role);
  }
  const auto labels = sensor::LabelSet::Create(declaration);
  CHECK(labels.ok()) << labels.status();
  return *labels;
}

}  // namespace cartographer::submap

#endif  // TEST_CARTOGRAPHER_SUBMAP_LABELS_WITH_ROLES_H_
