// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/option_reference.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/strip.h"
#include "cartographer/common/option_constraint.h"
#include "cartographer/common/options_loader.h"
#include "google/protobuf/descriptor.h"
#include "semantic_kiss/cli/terminal.h"
#include "semantic_kiss/manual/option_unit.h"

namespace semantic_kiss::manual {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr int kWidth = 100;

// The messages of one file that stand at one key: one, or the elements of a list.
struct Values {
  std::string file;
  std::vector<const Message*> messages;
};

// A table of options.
struct Table {
  std::string key;  // empty at the root; ends with "[]" if its values are the elements of a list
  const google::protobuf::Descriptor* descriptor;
  std::string comment{};
  std::vector<Values> values{};  // of the defaults first
};

// Text of a comment as Markdown. A "<" with a blank behind it begins no HTML.
std::string Escaped(const std::string& text) {
  return absl::StrReplaceAll(text, {{"*", "\\*"}, {"< ", "< "}, {"<= ", "<= "}, {"<", "\\<"}});
}

bool IsTable(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
}

std::string ValueText(const Values& values, const FieldDescriptor& field) {
  if (values.messages.empty()) return "none";
  return absl::StrCat("`",
                      absl::StrJoin(values.messages, ", ",
                                    [&](std::string* out, const Message* message) {
                                      absl::StrAppend(
                                          out, cartographer::common::OptionToLua(*message, field));
                                    }),
                      "`");
}

std::string TypeText(const FieldDescriptor& field) {
  std::string type = cartographer::common::DescribeScalar(field, field);
  if (field.is_repeated()) type = absl::StrCat("a list, each ", type);
  const std::string unit = UnitOf(field.name());
  return Escaped(unit.empty() ? type : absl::StrCat(type, ", in ", unit));
}

class Writer {
 public:
  explicit Writer(const OptionComments& comments) : comments_(comments) {}

  // Appends the section of a table and those of the tables in it.
  void Write(const Table& table) {
    if (!table.key.empty()) {
      absl::StrAppend(&contents_, "| [`", table.key, "`](#", Anchor(table.key), ") | ",
                      FirstSentence(table.comment), " |\n");
      absl::StrAppend(&sections_, "\n### `", table.key, "`\n\n",
                      cli::Wrapped(Escaped(table.comment), 0, kWidth), "\n");
    }
    std::string entries;
    for (int i = 0; i < table.descriptor->field_count(); ++i) {
      const FieldDescriptor& field = *table.descriptor->field(i);
      if (!IsTable(field)) entries += Entry(table, field);
    }
    if (!entries.empty()) absl::StrAppend(&sections_, "\n", entries);
    for (int i = 0; i < table.descriptor->field_count(); ++i) {
      const FieldDescriptor& field = *table.descriptor->field(i);
      if (IsTable(field)) Write(Inner(table, field));
    }
  }

  // The fields that should have had a comment, by their full names.
  const std::vector<std::string>& uncommented() const { return uncommented_; }

  std::string Text() const {
    return absl::StrCat("\n| table | about |\n|---|---|\n", contents_, sections_);
  }

 private:
  static std::string KeyIn(const Table& table, const FieldDescriptor& field) {
    return table.key.empty() ? field.name() : absl::StrCat(table.key, ".", field.name());
  }

  // What GitHub makes of a heading.
  static std::string Anchor(const std::string& key) {
    return absl::StrReplaceAll(key, {{".", ""}, {"[", ""}, {"]", ""}});
  }

  static std::string FirstSentence(const std::string& comment) {
    return Escaped(std::string(absl::StripSuffix(comment.substr(0, comment.find(". ")), ".")));
  }

  std::string Entry(const Table& table, const FieldDescriptor& field) {
    const std::string comment = comments_.Of(field.full_name());
    if (comment.empty()) uncommented_.push_back(field.full_name());
    const std::string value = ValueText(table.values[0], field);
    std::vector<std::string> changes;
    for (size_t i = 1; i < table.values.size(); ++i) {
      const std::string other = ValueText(table.values[i], field);
      if (other != value) changes.push_back(absl::StrCat(table.values[i].file, ": ", other));
    }
    return absl::StrCat("- **`", KeyIn(table, field), "`** = ", value, " (", TypeText(field),
                        ")<br>\n", cli::Wrapped(Escaped(comment), 2, kWidth),
                        changes.empty() ? "" : "<br>\n  In ", absl::StrJoin(changes, "; "), "\n");
  }

  Table Inner(const Table& table, const FieldDescriptor& field) {
    Table inner{KeyIn(table, field), field.message_type()};
    std::vector<std::string> comments = {comments_.Of(field.full_name()),
                                         comments_.Of(field.message_type()->full_name())};
    if (comments[0].empty() && comments[1].empty()) uncommented_.push_back(field.full_name());
    if (field.is_repeated()) {
      inner.key += "[]";
      comments.push_back("A list of tables; values are those of its elements in order.");
    }
    for (const std::string& comment : comments) {
      if (comment.empty()) continue;
      absl::StrAppend(&inner.comment, inner.comment.empty() ? "" : " ", comment);
    }
    for (const Values& values : table.values) {
      inner.values.push_back({values.file, Below(values.messages, field)});
    }
    return inner;
  }

  static std::vector<const Message*> Below(const std::vector<const Message*>& messages,
                                           const FieldDescriptor& field) {
    std::vector<const Message*> below;
    for (const Message* message : messages) {
      const auto& reflection = *message->GetReflection();
      if (!field.is_repeated()) {
        below.push_back(&reflection.GetMessage(*message, &field));
        continue;
      }
      for (int i = 0; i < reflection.FieldSize(*message, &field); ++i) {
        below.push_back(&reflection.GetRepeatedMessage(*message, &field, i));
      }
    }
    return below;
  }

  const OptionComments& comments_;
  std::string contents_, sections_;
  std::vector<std::string> uncommented_;
};

Table Root(const OptionTree& tree) {
  Table root{"", tree.defaults.options->GetDescriptor()};
  root.values.push_back({tree.defaults.name, {tree.defaults.options.get()}});
  for (const OptionFile& system : tree.systems) {
    root.values.push_back({absl::StrCat("`", system.name, "`"), {system.options.get()}});
  }
  return root;
}

constexpr char kIntroduction[] = R"(# Options

<!-- Generated from the comments in proto/ and the values in configuration_files/.
     Renew it by: ninja -C build renew_options -->

Everything that decides about results is an option in a Lua file, given as `--config=FILE`. A file of
your own begins with one that is there and changes what it must; a key that does not exist, a value of
another type or out of its range is an error that names the key. `semantic_kiss config --config=FILE`
prints all values that a file resolves to.

Below stand for each option: its key, its default, what it may be, its meaning, and which of the shipped
files set something else. [tuning.md](tuning.md) goes the other way, from what is wrong to the option
that mends it; label sets are described in [labels.md](labels.md).
)";

}  // namespace

absl::StatusOr<std::string> OptionReference(const std::vector<OptionTree>& trees,
                                            const OptionComments& comments) {
  std::string text = kIntroduction;
  for (const OptionTree& tree : trees) {
    Writer writer(comments);
    writer.Write(Root(tree));
    if (!writer.uncommented().empty()) {
      return absl::InvalidArgumentError(absl::StrCat(
          "options need a comment above their field (tables: or above their message): ",
          absl::StrJoin(writer.uncommented(), ", ")));
    }
    absl::StrAppend(&text, "\n## Of ", tree.commands, "\n\nDefaults are in `configuration_files/",
                    tree.defaults.name, "`. A file that changes one:\n\n```lua\n", tree.example,
                    "```\n", writer.Text());
  }
  return text;
}

}  // namespace semantic_kiss::manual
