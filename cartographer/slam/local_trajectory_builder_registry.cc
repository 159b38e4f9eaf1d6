// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/local_trajectory_builder_registry.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "glog/logging.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/message.h"

namespace cartographer::slam {

using google::protobuf::FieldDescriptor;

void LocalTrajectoryBuilderRegistry::Register(const std::string& name, Factory factory) {
  CHECK(factories_.emplace(name, std::move(factory)).second)
      << "Local trajectory builder '" << name << "' is registered twice";
}

absl::StatusOr<std::unique_ptr<LocalTrajectoryBuilder>> LocalTrajectoryBuilderRegistry::Create(
    const google::protobuf::Message& options, const sensor::LabelSet& labels) const {
  const google::protobuf::Descriptor& type = *options.GetDescriptor();
  const google::protobuf::Reflection& reflection = *options.GetReflection();
  const FieldDescriptor* const name_field = type.FindFieldByName("name");
  CHECK(name_field != nullptr && name_field->cpp_type() == FieldDescriptor::CPPTYPE_STRING)
      << type.full_name();
  const std::string name = reflection.GetString(options, name_field);
  const auto factory = factories_.find(name);
  if (factory == factories_.end()) {
    return absl::InvalidArgumentError(absl::StrCat(
        "local_trajectory_builder.name = \"", name, "\" is not known; known are: ",
        absl::StrJoin(factories_, ", ",
                      [](std::string* out, const auto& entry) { out->append(entry.first); })));
  }
  const FieldDescriptor* const builder_field = type.FindFieldByName(name);
  if (builder_field == nullptr || builder_field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
    return absl::InvalidArgumentError(absl::StrCat(
        "local_trajectory_builder has no options table '", name, "' for the builder of that name"));
  }
  return factory->second(reflection.GetMessage(options, builder_field), labels);
}

}  // namespace cartographer::slam
