// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/sensor/label_set.h"

#include <algorithm>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "cartographer/common/nearest_name.h"
#include "cartographer/common/options_loader.h"
#include "cartographer/common/status.h"
#include "cartographer/sensor/label_set_check.h"

namespace cartographer::sensor {
namespace {

constexpr size_t kNumFileIds = 65536;
constexpr int16_t kNotListed = -1;

bool HasRoleWord(const proto::LabelClass& label_class, LabelRole role) {
  const auto& roles = label_class.roles();
  return std::find(roles.begin(), roles.end(), RoleWord(role)) != roles.end();
}

Color ColorOfClass(const proto::LabelClass& label_class) {
  return {static_cast<uint8_t>(label_class.color(0)), static_cast<uint8_t>(label_class.color(1)),
          static_cast<uint8_t>(label_class.color(2))};
}

}  // namespace

LabelSet::LabelSet()
    : entries_{{"unlabeled", Color{160, 160, 160}, 1.f, 0}},
      label_of_file_id_(kNumFileIds, kNotListed) {
  label_of_file_id_[0] = 0;
  label_of_name_.emplace("unlabeled", kUnlabeled);
  roles_[static_cast<size_t>(LabelRole::kUnlabeled)].Insert(kUnlabeled);
}

absl::StatusOr<LabelSet> LabelSet::Create(const proto::LabelSet& declaration) {
  RETURN_IF_ERROR(CheckLabelSet(declaration));
  LabelSet set;
  set.declaration_ = declaration;
  set.entries_.clear();
  set.label_of_name_.clear();
  set.label_of_file_id_[0] = kNotListed;
  set.AddUnlabeled();
  for (const proto::LabelClass& label_class : declaration.classes()) set.AddOwnLabel(label_class);
  for (const proto::LabelClass& label_class : declaration.classes()) {
    if (label_class.has_merged_into()) {
      set.List(label_class, set.label_of_name_.at(label_class.merged_into()));
    }
  }
  return set;
}

absl::StatusOr<LabelSet> LabelSet::Load(const common::LuaFile& file) {
  proto::LabelSet declaration;
  RETURN_IF_ERROR(common::LoadOptions(file, &declaration));
  absl::StatusOr<LabelSet> set = Create(declaration);
  if (!set.ok()) return common::AddContext(set.status(), file.path);
  return set;
}

absl::StatusOr<Label> LabelSet::FromName(absl::string_view name) const {
  const auto it = label_of_name_.find(name);
  if (it != label_of_name_.end()) return it->second;
  std::vector<std::string> known;
  for (const proto::LabelClass& label_class : declaration_.classes()) {
    known.push_back(label_class.name());
  }
  if (known.empty()) known.push_back(entries_[0].name);
  return absl::NotFoundError(absl::StrCat("no class \"", name, "\" in label set \"", this->name(),
                                          "\"; ", common::SuggestName(name, known)));
}

absl::StatusOr<LabelMask> LabelSet::FromNames(
    const google::protobuf::RepeatedPtrField<std::string>& names) const {
  LabelMask mask;
  for (const std::string& name : names) {
    ASSIGN_OR_RETURN(const Label label, FromName(name));
    mask.Insert(label);
  }
  return mask;
}

void LabelSet::AddUnlabeled() {
  const auto& classes = declaration_.classes();
  AddEntry(*std::find_if(classes.begin(), classes.end(), [](const proto::LabelClass& candidate) {
    return HasRoleWord(candidate, LabelRole::kUnlabeled) && !candidate.has_merged_into();
  }));
}

void LabelSet::AddOwnLabel(const proto::LabelClass& label_class) {
  if (label_class.has_merged_into()) return;
  if (HasRoleWord(label_class, LabelRole::kUnlabeled)) return List(label_class, kUnlabeled);
  const Label label{static_cast<uint8_t>(entries_.size())};
  AddEntry(label_class);
  List(label_class, label);
  for (size_t role = 0; role < kNumLabelRoles; ++role) {
    if (HasRoleWord(label_class, static_cast<LabelRole>(role))) roles_[role].Insert(label);
  }
}

void LabelSet::AddEntry(const proto::LabelClass& label_class) {
  const double certainty =
      label_class.has_certainty() ? label_class.certainty() : declaration_.default_certainty();
  entries_.push_back({label_class.name(), ColorOfClass(label_class), static_cast<float>(certainty),
                      static_cast<uint16_t>(label_class.id())});
}

void LabelSet::List(const proto::LabelClass& label_class, Label label) {
  label_of_file_id_[label_class.id()] = static_cast<int16_t>(Index(label));
  label_of_name_.emplace(label_class.name(), label);
}

}  // namespace cartographer::sensor
