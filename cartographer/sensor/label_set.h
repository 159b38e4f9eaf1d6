// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SENSOR_LABEL_SET_H_
#define CARTOGRAPHER_SENSOR_LABEL_SET_H_

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"
#include "cartographer/common/lua_file.h"
#include "cartographer/sensor/label.h"
#include "cartographer/sensor/proto/label_set.pb.h"

namespace cartographer::sensor {

struct Color {
  uint8_t red = 0, green = 0, blue = 0;
};

// The classes of a data set: how its files number them, what they are called and what they are
// for. An immutable value.
//
// Labels are dense: kUnlabeled is 0, the other unmerged classes follow in the order of the
// declaration. A class that merges into another shares the other's label, so "the labels agree" is
// an integer comparison; classes with the role `unlabeled` all share kUnlabeled.
class LabelSet {
 public:
  // A set that knows only kUnlabeled, for scans without labels and maps of other systems.
  LabelSet();

  // Errors name the class: a duplicate id or name; a name that is empty or has commas or blanks
  // (flags list names); an unknown `merged_into`, a chain of merges, a merge that loses a role (a
  // moving class cannot become a static one); an unknown role, or others beside `unlabeled`; no
  // class with the role `unlabeled`; more than 255 labels besides; a colour without three
  // components; a number out of its range.
  static absl::StatusOr<LabelSet> Create(const proto::LabelSet& declaration);

  // Create() for a Lua file such as configuration_files/labels/semantic_kitti.lua.
  static absl::StatusOr<LabelSet> Load(const common::LuaFile& file);

  // Number of labels, kUnlabeled included: valid labels are 0..size()-1.
  size_t size() const { return entries_.size(); }

  const std::string& name() const { return declaration_.name(); }
  const std::string& Name(Label label) const { return entries_[Index(label)].name; }
  Color ColorOf(Label label) const { return entries_[Index(label)].color; }
  // The certainty of a point of this class whose scan brings none.
  float DefaultCertainty(Label label) const { return entries_[Index(label)].certainty; }
  // The id under which files list this label (of the merge's target where classes merge).
  uint16_t FileId(Label label) const { return entries_[Index(label)].file_id; }

  bool HasRole(Label label, LabelRole role) const { return WithRole(role).Contains(label); }
  const LabelMask& WithRole(LabelRole role) const { return roles_[static_cast<size_t>(role)]; }

  // The label of a file's id; nullopt if the set does not list the id (callers count these and
  // go on with kUnlabeled).
  std::optional<Label> FromFileId(uint16_t id) const {
    const int16_t label = label_of_file_id_[id];
    if (label < 0) return std::nullopt;
    return Label{static_cast<uint8_t>(label)};
  }

  // The label called `name`, the name of a merged class included; NotFound tells the nearest.
  absl::StatusOr<Label> FromName(absl::string_view name) const;
  // The labels of those names; the first name that is not known is the error.
  absl::StatusOr<LabelMask> FromNames(
      const google::protobuf::RepeatedPtrField<std::string>& names) const;

  const proto::LabelSet& declaration() const { return declaration_; }

 private:
  struct Entry {
    std::string name;
    Color color;
    float certainty = 1.f;
    uint16_t file_id = 0;
  };

  // Steps of Create(): the entry of kUnlabeled; then a class that is not merged.
  void AddUnlabeled();
  void AddOwnLabel(const proto::LabelClass& label_class);
  void AddEntry(const proto::LabelClass& label_class);
  // Makes the class's id and name lead to `label`.
  void List(const proto::LabelClass& label_class, Label label);

  proto::LabelSet declaration_;
  std::vector<Entry> entries_;
  std::vector<int16_t> label_of_file_id_;  // 65536 entries, -1: not listed
  std::map<std::string, Label, std::less<>> label_of_name_;
  std::array<LabelMask, kNumLabelRoles> roles_;
};

}  // namespace cartographer::sensor

#endif  // CARTOGRAPHER_SENSOR_LABEL_SET_H_
