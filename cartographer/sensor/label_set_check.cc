// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/sensor/label_set_check.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/nearest_name.h"
#include "cartographer/common/status.h"

namespace cartographer::sensor {
namespace {

constexpr int kMaxFileId = 65535;
constexpr int kMaxColor = 255;

std::string Quoted(absl::string_view name) { return absl::StrCat("class \"", name, "\": "); }

template <typename... Args>
absl::Status Error(const Args&... args) {
  return absl::InvalidArgumentError(absl::StrCat(args...));
}

bool IsCertainty(double value) { return value >= 0. && value <= 1.; }

bool Has(const proto::LabelClass& label_class, absl::string_view role) {
  return std::find(label_class.roles().begin(), label_class.roles().end(), role) !=
         label_class.roles().end();
}

absl::Status CheckRoles(const proto::LabelClass& label_class) {
  std::vector<std::string> words;
  for (size_t i = 0; i < kNumLabelRoles; ++i) {
    words.emplace_back(RoleWord(static_cast<LabelRole>(i)));
  }
  for (const std::string& role : label_class.roles()) {
    if (std::find(words.begin(), words.end(), role) != words.end()) continue;
    return Error(Quoted(label_class.name()), "unknown role \"", role, "\"; ",
                 common::SuggestName(role, words));
  }
  if (Has(label_class, RoleWord(LabelRole::kUnlabeled)) && label_class.roles_size() > 1) {
    return Error(Quoted(label_class.name()), "the role \"unlabeled\" excludes all others");
  }
  return absl::OkStatus();
}

absl::Status CheckClass(const proto::LabelClass& label_class) {
  const std::string& name = label_class.name();
  if (name.empty() || name.find_first_of(", \t\n") != std::string::npos) {
    return Error(Quoted(name), "a name must not be empty and have no commas or blanks");
  }
  if (label_class.id() < 0 || label_class.id() > kMaxFileId) {
    return Error(Quoted(name), "id = ", label_class.id(), "; must satisfy 0 <= x <= ", kMaxFileId);
  }
  if (label_class.color_size() != 3) {
    return Error(Quoted(name), "color has ", label_class.color_size(),
                 " components; must have 3: red, green, blue");
  }
  for (const int component : label_class.color()) {
    if (component < 0 || component > kMaxColor) {
      return Error(Quoted(name), "color has a component of ", component,
                   "; must satisfy 0 <= x <= ", kMaxColor);
    }
  }
  if (label_class.has_certainty() && !IsCertainty(label_class.certainty())) {
    return Error(Quoted(name), "certainty = ", label_class.certainty(),
                 "; must satisfy 0 <= x <= 1");
  }
  return CheckRoles(label_class);
}

using ClassOfName = std::map<std::string, const proto::LabelClass*>;

absl::Status CheckUnique(const proto::LabelSet& declaration, ClassOfName* class_of_name) {
  std::map<int, const proto::LabelClass*> class_of_id;
  for (const proto::LabelClass& label_class : declaration.classes()) {
    const std::string& name = label_class.name();
    if (!class_of_name->emplace(name, &label_class).second) {
      return Error(Quoted(name), "the name is given twice; names must differ");
    }
    const auto [other, is_new] = class_of_id.emplace(label_class.id(), &label_class);
    if (!is_new) {
      return Error(Quoted(name), "id ", label_class.id(), " is that of class \"",
                   other->second->name(), "\" already; ids must differ");
    }
  }
  return absl::OkStatus();
}

absl::Status CheckMerge(const proto::LabelClass& label_class, const ClassOfName& class_of_name) {
  const std::string& name = label_class.name();
  const std::string& target_name = label_class.merged_into();
  const auto target = class_of_name.find(target_name);
  if (target == class_of_name.end()) {
    std::vector<std::string> known;
    for (const auto& [known_name, unused] : class_of_name) known.push_back(known_name);
    return Error(Quoted(name), "merged_into = \"", target_name, "\" is no class of the set; ",
                 common::SuggestName(target_name, known));
  }
  if (target_name == name) return Error(Quoted(name), "is merged into itself; leave that out");
  if (target->second->has_merged_into()) {
    return Error(Quoted(name), "merged_into = \"", target_name,
                 "\", which is merged itself; name \"", target->second->merged_into(), "\"");
  }
  for (const std::string& role : label_class.roles()) {
    if (Has(*target->second, role)) continue;
    return Error(Quoted(name), "has the role \"", role, "\", which would be lost: \"", target_name,
                 "\", into which it is merged, has it not; merge classes of the same roles");
  }
  return absl::OkStatus();
}

absl::Status CheckNumbers(const proto::LabelSet& declaration) {
  size_t num_unlabeled = 0, num_labels = 0;
  for (const proto::LabelClass& label_class : declaration.classes()) {
    if (label_class.has_merged_into()) continue;
    ++(Has(label_class, RoleWord(LabelRole::kUnlabeled)) ? num_unlabeled : num_labels);
  }
  if (num_unlabeled == 0) {
    return Error("no class has the role \"unlabeled\"; give it to the class of points that ",
                 "nobody labelled");
  }
  if (num_labels >= kMaxLabels) {
    return Error(num_labels, " classes that are neither merged nor unlabeled; there may be ",
                 kMaxLabels - 1, ", so merge some");
  }
  return absl::OkStatus();
}

}  // namespace

absl::string_view RoleWord(LabelRole role) {
  switch (role) {
    case LabelRole::kMoving:
      return "moving";
    case LabelRole::kMovable:
      return "movable";
    case LabelRole::kCritical:
      return "critical";
    case LabelRole::kGround:
      return "ground";
    case LabelRole::kUnlabeled:
      return "unlabeled";
  }
  return "";
}

absl::StatusOr<LabelRole> RoleFromWord(absl::string_view word) {
  std::vector<std::string> known;
  for (size_t i = 0; i < kNumLabelRoles; ++i) {
    const auto role = static_cast<LabelRole>(i);
    if (RoleWord(role) == word) return role;
    known.emplace_back(RoleWord(role));
  }
  return absl::InvalidArgumentError(
      absl::StrCat("no role \"", word, "\"; ", common::SuggestName(word, known)));
}

absl::Status CheckLabelSet(const proto::LabelSet& declaration) {
  if (!IsCertainty(declaration.default_certainty())) {
    return Error("default_certainty = ", declaration.default_certainty(),
                 "; must satisfy 0 <= x <= 1");
  }
  for (const proto::LabelClass& label_class : declaration.classes()) {
    RETURN_IF_ERROR(CheckClass(label_class));
  }
  ClassOfName class_of_name;
  RETURN_IF_ERROR(CheckUnique(declaration, &class_of_name));
  for (const proto::LabelClass& label_class : declaration.classes()) {
    if (label_class.has_merged_into()) RETURN_IF_ERROR(CheckMerge(label_class, class_of_name));
  }
  return CheckNumbers(declaration);
}

}  // namespace cartographer::sensor
