// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cartographer/common/lua_value.h"
#include "cartographer/common/options_loader.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/message.h"

namespace cartographer::common {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr size_t kMaxLineLength = 100;

// The number, boolean, string or word of a field, of its element `index` if it is repeated.
std::string ScalarToLua(const Message& message, const FieldDescriptor& field, int index) {
  const Reflection& get = *message.GetReflection();
  const FieldDescriptor* const f = &field;
  const bool many = field.is_repeated();
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return absl::StrCat(many ? get.GetRepeatedInt32(message, f, index)
                               : get.GetInt32(message, f));
    case FieldDescriptor::CPPTYPE_INT64:
      return absl::StrCat(many ? get.GetRepeatedInt64(message, f, index)
                               : get.GetInt64(message, f));
    case FieldDescriptor::CPPTYPE_UINT32:
      return absl::StrCat(many ? get.GetRepeatedUInt32(message, f, index)
                               : get.GetUInt32(message, f));
    case FieldDescriptor::CPPTYPE_UINT64:
      return absl::StrCat(many ? get.GetRepeatedUInt64(message, f, index)
                               : get.GetUInt64(message, f));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return LuaNumberLiteral(many ? get.GetRepeatedDouble(message, f, index)
                                   : get.GetDouble(message, f));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return LuaNumberLiteral(many ? get.GetRepeatedFloat(message, f, index)
                                   : get.GetFloat(message, f));
    case FieldDescriptor::CPPTYPE_BOOL:
      return (many ? get.GetRepeatedBool(message, f, index) : get.GetBool(message, f)) ? "true"
                                                                                       : "false";
    case FieldDescriptor::CPPTYPE_ENUM:
      return LuaStringLiteral(
          (many ? get.GetRepeatedEnum(message, f, index) : get.GetEnum(message, f))->name());
    default:
      return LuaStringLiteral(many ? get.GetRepeatedString(message, f, index)
                                   : get.GetString(message, f));
  }
}

// A value that is not written yet: text, or the entries of a table.
struct Node {
  std::string key;   // with " = ", empty in a list
  std::string text;  // of a scalar
  std::vector<Node> children;
  bool is_table = false;
  bool may_be_one_line = false;  // a table that is broken only if its line gets too long
};

std::string KeyToLua(const std::string& name) {
  return IsLuaIdentifier(name) ? name + " = " : absl::StrCat("[", LuaStringLiteral(name), "] = ");
}

Node MessageToNode(const Message& message);

Node MapToNode(const Message& message, const FieldDescriptor& field) {
  Node node;
  const Reflection& reflection = *message.GetReflection();
  const FieldDescriptor& key_field = *field.message_type()->map_key();
  const FieldDescriptor& value_field = *field.message_type()->map_value();
  std::vector<std::pair<std::string, const Message*>> entries;
  for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
    const Message& entry = reflection.GetRepeatedMessage(message, &field, i);
    entries.emplace_back(entry.GetReflection()->GetString(entry, &key_field), &entry);
  }
  std::sort(entries.begin(), entries.end());
  for (const auto& [key, entry] : entries) {
    Node value;
    if (value_field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      value = MessageToNode(entry->GetReflection()->GetMessage(*entry, &value_field));
    } else {
      value.text = ScalarToLua(*entry, value_field, 0);
    }
    value.key = KeyToLua(key);
    node.children.push_back(std::move(value));
  }
  node.is_table = true;
  return node;
}

Node ListToNode(const Message& message, const FieldDescriptor& field) {
  Node node;
  const Reflection& reflection = *message.GetReflection();
  const bool of_messages = field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
  for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
    Node element;
    if (of_messages) {
      element = MessageToNode(reflection.GetRepeatedMessage(message, &field, i));
      element.may_be_one_line = true;
    } else {
      element.text = ScalarToLua(message, field, i);
    }
    node.children.push_back(std::move(element));
  }
  node.is_table = true;
  node.may_be_one_line = !of_messages;
  return node;
}

Node FieldToNode(const Message& message, const FieldDescriptor& field) {
  if (field.is_map()) return MapToNode(message, field);
  if (field.is_repeated()) return ListToNode(message, field);
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
    return MessageToNode(message.GetReflection()->GetMessage(message, &field));
  }
  Node node;
  node.text = ScalarToLua(message, field, 0);
  return node;
}

Node MessageToNode(const Message& message) {
  const Descriptor& descriptor = *message.GetDescriptor();
  Node node;
  for (int i = 0; i < descriptor.field_count(); ++i) {
    const FieldDescriptor& field = *descriptor.field(i);
    const bool may_be_missing =
        field.has_optional_keyword() || field.real_containing_oneof() != nullptr;
    if (may_be_missing && !message.GetReflection()->HasField(message, &field)) continue;
    Node child = FieldToNode(message, field);
    child.key = KeyToLua(field.name());
    node.children.push_back(std::move(child));
  }
  node.is_table = true;
  return node;
}

std::string OnOneLine(const Node& node) {
  if (!node.is_table) return node.text;
  if (node.children.empty()) return "{}";
  return absl::StrCat("{ ",
                      absl::StrJoin(node.children, ", ",
                                    [](std::string* out, const Node& child) {
                                      absl::StrAppend(out, child.key, OnOneLine(child));
                                    }),
                      " }");
}

void Write(const Node& node, size_t indentation, std::string* lua) {
  if (!node.is_table || node.may_be_one_line || node.children.empty()) {
    const std::string line = OnOneLine(node);
    const bool fits = indentation + node.key.size() + line.size() < kMaxLineLength;
    if (!node.is_table || node.children.empty() || fits) {
      lua->append(line);
      return;
    }
  }
  lua->append("{\n");
  for (const Node& child : node.children) {
    lua->append(indentation + 2, ' ').append(child.key);
    Write(child, indentation + 2, lua);
    lua->append(",\n");
  }
  lua->append(indentation, ' ').append("}");
}

}  // namespace

std::string OptionsToLua(const Message& options) {
  std::string lua = "return ";
  Write(MessageToNode(options), 0, &lua);
  return lua + "\n";
}

std::string OptionToLua(const Message& options, const FieldDescriptor& field) {
  return OnOneLine(FieldToNode(options, field));
}

}  // namespace cartographer::common
