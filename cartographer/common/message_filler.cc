// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/message_filler.h"

#include <cstddef>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/field_value.h"
#include "cartographer/common/nearest_name.h"
#include "cartographer/common/option_constraint.h"
#include "glog/logging.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/message.h"

namespace cartographer::common {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::OneofDescriptor;

std::string ChildPath(const std::string& path, const std::string& key) {
  if (!IsLuaIdentifier(key)) return absl::StrCat(path, "[", LuaStringLiteral(key), "]");
  return path.empty() ? key : absl::StrCat(path, ".", key);
}

std::vector<std::string> FieldNames(const Descriptor& descriptor) {
  std::vector<std::string> names;
  for (int i = 0; i < descriptor.field_count(); ++i) names.push_back(descriptor.field(i)->name());
  return names;
}

// Walks the table and the message side by side; keeps the first error and counts the others.
class Filler {
 public:
  void FillTable(const LuaValue& table, const std::string& path, Message* message);

  absl::Status Result() const {
    if (num_errors_ < 2) return first_error_;
    const std::string more =
        absl::StrCat(" (and ", num_errors_ - 1, " more error", num_errors_ == 2 ? "" : "s", ")");
    return absl::Status(first_error_.code(), absl::StrCat(first_error_.message(), more));
  }

 private:
  void AddError(const std::string& message) {
    if (++num_errors_ == 1) first_error_ = absl::InvalidArgumentError(message);
  }

  void RejectUnknownKeys(const LuaValue& table, const std::string& path,
                         const Descriptor& descriptor);
  void RejectAlternatives(const LuaValue& table, const std::string& path,
                          const OneofDescriptor& oneof);
  void FillField(const LuaValue& value, const std::string& path, const FieldDescriptor& field,
                 Message* message);
  void FillList(const LuaValue& value, const std::string& path, const FieldDescriptor& field,
                Message* message);
  void FillMap(const LuaValue& value, const std::string& path, const FieldDescriptor& field,
               Message* message);
  void FillScalar(const LuaValue& value, const std::string& path, const FieldTarget& target);
  void AddMistyped(const LuaValue& value, const std::string& path, const FieldDescriptor& field);

  int num_errors_ = 0;
  absl::Status first_error_;
};

void Filler::FillTable(const LuaValue& table, const std::string& path, Message* message) {
  const Descriptor& descriptor = *message->GetDescriptor();
  RejectUnknownKeys(table, path, descriptor);
  for (int i = 0; i < descriptor.real_oneof_decl_count(); ++i) {
    RejectAlternatives(table, path, *descriptor.oneof_decl(i));
  }
  for (int i = 0; i < descriptor.field_count(); ++i) {
    const FieldDescriptor& field = *descriptor.field(i);
    const std::string field_path = ChildPath(path, field.name());
    if (const LuaValue* const value = table.Find(field.name()); value != nullptr) {
      FillField(*value, field_path, field, message);
    } else if (!field.has_optional_keyword() && field.real_containing_oneof() == nullptr) {
      AddError(absl::StrCat("missing key ", field_path, "; must be ", DescribeRequirement(field)));
    }
  }
}

void Filler::RejectUnknownKeys(const LuaValue& table, const std::string& path,
                               const Descriptor& descriptor) {
  for (const LuaNamedValue& entry : table.named) {
    if (descriptor.FindFieldByName(entry.name) != nullptr) continue;
    AddError(absl::StrCat("unknown key ", ChildPath(path, entry.name), "; ",
                          SuggestName(entry.name, FieldNames(descriptor))));
  }
}

void Filler::RejectAlternatives(const LuaValue& table, const std::string& path,
                                const OneofDescriptor& oneof) {
  std::vector<std::string> present;
  for (int i = 0; i < oneof.field_count(); ++i) {
    if (table.Find(oneof.field(i)->name()) != nullptr) present.push_back(oneof.field(i)->name());
  }
  if (present.size() < 2) return;
  AddError(absl::StrCat(ChildPath(path, present[0]), " and ", ChildPath(path, present[1]),
                        " exclude each other; give only one"));
}

void Filler::FillField(const LuaValue& value, const std::string& path, const FieldDescriptor& field,
                       Message* message) {
  if (field.is_map()) return FillMap(value, path, field, message);
  if (field.is_repeated()) return FillList(value, path, field, message);
  if (field.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
    return FillScalar(value, path, {message, &field, &field});
  }
  if (value.kind != LuaValue::Kind::kTable) return AddMistyped(value, path, field);
  FillTable(value, path, message->GetReflection()->MutableMessage(message, &field));
}

void Filler::FillList(const LuaValue& value, const std::string& path, const FieldDescriptor& field,
                      Message* message) {
  if (value.kind != LuaValue::Kind::kList && !value.IsEmptyTable()) {
    return AddMistyped(value, path, field);
  }
  for (size_t i = 0; i < value.list.size(); ++i) {
    const LuaValue& element = value.list[i];
    const std::string element_path = absl::StrCat(path, "[", i + 1, "]");
    if (field.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
      FillScalar(element, element_path, {message, &field, &field});
    } else if (element.kind != LuaValue::Kind::kTable) {
      AddError(absl::StrCat(element_path, " = ", Describe(element),
                            "; must be a table with named keys"));
    } else {
      FillTable(element, element_path, message->GetReflection()->AddMessage(message, &field));
    }
  }
}

void Filler::FillMap(const LuaValue& value, const std::string& path, const FieldDescriptor& field,
                     Message* message) {
  const FieldDescriptor& key_field = *field.message_type()->map_key();
  const FieldDescriptor& value_field = *field.message_type()->map_value();
  CHECK_EQ(key_field.cpp_type(), FieldDescriptor::CPPTYPE_STRING)
      << field.full_name() << ": options can only be maps with string keys";
  if (value.kind != LuaValue::Kind::kTable) return AddMistyped(value, path, field);
  for (const LuaNamedValue& entry : value.named) {
    const std::string entry_path = ChildPath(path, entry.name);
    Message* const map_entry = message->GetReflection()->AddMessage(message, &field);
    LuaValue key;
    key.kind = LuaValue::Kind::kString;
    key.text = entry.name;
    FillScalar(key, entry_path, {map_entry, &key_field, &key_field});
    if (value_field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      FillField(entry.value, entry_path, value_field, map_entry);
    } else {
      FillScalar(entry.value, entry_path, {map_entry, &value_field, &field});
    }
  }
}

void Filler::FillScalar(const LuaValue& value, const std::string& path, const FieldTarget& target) {
  const absl::Status status = StoreScalar(value, target);
  if (!status.ok()) AddError(absl::StrCat(path, " = ", Describe(value), "; ", status.message()));
}

void Filler::AddMistyped(const LuaValue& value, const std::string& path,
                         const FieldDescriptor& field) {
  AddError(absl::StrCat(path, " = ", Describe(value), "; must be ", DescribeRequirement(field)));
}

}  // namespace

absl::Status FillMessage(const LuaValue& table, Message* message) {
  message->Clear();
  if (table.kind == LuaValue::Kind::kTable) {
    Filler filler;
    filler.FillTable(table, "", message);
    return filler.Result();
  }
  return absl::InvalidArgumentError(
      absl::StrCat("returned ", Describe(table), "; must be a table with named keys"));
}

}  // namespace cartographer::common
