// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/score_model.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "absl/strings/str_cat.h"
#include "cartographer/common/nearest_name.h"
#include "cartographer/common/status.h"
#include "cartographer/sensor/label_set_check.h"

namespace cartographer::scan_matching {
namespace {

constexpr int kNoGroup = -1;

absl::StatusOr<sensor::LabelRole> RoleFromWord(const std::string& word) {
  std::vector<std::string> known;
  for (size_t i = 0; i < sensor::kNumLabelRoles; ++i) {
    const auto role = static_cast<sensor::LabelRole>(i);
    if (sensor::RoleWord(role) == word) return role;
    known.emplace_back(sensor::RoleWord(role));
  }
  return absl::InvalidArgumentError(
      absl::StrCat("no role \"", word, "\"; ", common::SuggestName(word, known)));
}

// The group of every label, kNoGroup where there is none: filled in the order of precedence, names,
// roles, all that is left.
class GroupOfLabel {
 public:
  explicit GroupOfLabel(const sensor::LabelSet& labels)
      : labels_(labels), groups_(labels.size(), kNoGroup) {}

  absl::Status AddNamed(const proto::LabelGroup& group, int index) {
    for (const std::string& name : group.labels()) {
      ASSIGN_OR_RETURN(const sensor::Label label, labels_.FromName(name));
      int& present = groups_[sensor::Index(label)];
      if (present != kNoGroup && present != index) {
        return absl::InvalidArgumentError(
            absl::StrCat("label \"", name, "\" is in another group already"));
      }
      present = index;
    }
    return absl::OkStatus();
  }

  absl::Status AddByRole(const proto::LabelGroup& group, int index) {
    for (const std::string& word : group.roles()) {
      ASSIGN_OR_RETURN(const sensor::LabelRole role, RoleFromWord(word));
      AddFree(index, [&](sensor::Label label) { return labels_.HasRole(label, role); });
    }
    return absl::OkStatus();
  }

  void AddRest(const proto::LabelGroup& group, int index) {
    if (group.labels().empty() && group.roles().empty()) {
      AddFree(index, [](sensor::Label) { return true; });
    }
  }

  std::vector<sensor::Label> Members(int index) const {
    std::vector<sensor::Label> members;
    for (size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i] == index) members.push_back(sensor::Label{static_cast<uint8_t>(i)});
    }
    return members;
  }

 private:
  template <typename Predicate>
  void AddFree(int index, const Predicate& belongs) {
    for (size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i] == kNoGroup && belongs(sensor::Label{static_cast<uint8_t>(i)})) {
        groups_[i] = index;
      }
    }
  }

  const sensor::LabelSet& labels_;
  std::vector<int> groups_;
};

absl::StatusOr<GroupOfLabel> Group(const proto::ScoreOptions& options,
                                   const sensor::LabelSet& labels) {
  GroupOfLabel result(labels);
  const auto in_group = [&](const absl::Status& status, int i) {
    return common::AddContext(status, absl::StrCat("group \"", options.groups(i).name(), "\""));
  };
  for (int i = 0; i < options.groups_size(); ++i) {
    RETURN_IF_ERROR(in_group(result.AddNamed(options.groups(i), i), i));
  }
  for (int i = 0; i < options.groups_size(); ++i) {
    RETURN_IF_ERROR(in_group(result.AddByRole(options.groups(i), i), i));
  }
  for (int i = 0; i < options.groups_size(); ++i) result.AddRest(options.groups(i), i);
  return result;
}

}  // namespace

absl::StatusOr<ScoreModel> ScoreModel::Create(const proto::ScoreOptions& options,
                                              const sensor::LabelSet& labels) {
  ScoreModel model;
  model.max_range_m_ = options.max_range_m();
  model.layer_of_label_.fill(kNotMatched);
  if (options.score() == "occupancy") {
    model.UseOccupancy(labels);
    return model;
  }
  model.partial_agreement_ = options.score() == "max_layer" ? 1. : options.partial_agreement();
  ASSIGN_OR_RETURN(const GroupOfLabel group_of_label, Group(options, labels));
  for (int group = 0; group < options.groups_size(); ++group) {
    model.AddLayers(group_of_label.Members(group), options.groups(group));
  }
  return model;
}

void ScoreModel::AddLayers(const std::vector<sensor::Label>& labels,
                           const proto::LabelGroup& options) {
  const int weight = static_cast<int>(std::lround(options.weight() * kWeightSteps));
  if (weight == 0) return;
  const int first_layer = num_layers();
  for (const sensor::Label label : labels) {
    // Groups are renumbered, so that those without a label that counts leave no gap.
    const bool begins_group = num_layers() == first_layer || options.apart();
    layer_of_label_[sensor::Index(label)] = num_layers();
    weight_of_label_[sensor::Index(label)] = weight;
    group_of_layer_.push_back(begins_group ? num_groups() : num_groups() - 1);
    saturation_of_layer_.push_back(options.saturation_hits());
  }
}

void ScoreModel::UseOccupancy(const sensor::LabelSet& labels) {
  occupancy_ = true;
  group_of_layer_ = {0};
  saturation_of_layer_ = {1};
  for (size_t i = 0; i < labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    if (labels.HasRole(label, sensor::LabelRole::kGround) ||
        labels.HasRole(label, sensor::LabelRole::kMoving)) {
      continue;
    }
    layer_of_label_[i] = 0;
    weight_of_label_[i] = kWeightSteps;
  }
}

int ScoreModel::Agreement(int layer, int hits, bool dominant) const {
  const int saturation = saturation_of_layer_[layer];
  const double share = static_cast<double>(std::min(hits, saturation)) / saturation;
  const double fraction = dominant || occupancy_ ? 1. : partial_agreement_;
  return static_cast<int>(std::lround(kFullAgreement * share * fraction));
}

}  // namespace cartographer::scan_matching
