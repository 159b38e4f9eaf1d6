// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/options_loader.h"

#include <memory>

#include "absl/strings/str_cat.h"
#include "cartographer/common/lua_evaluator.h"
#include "cartographer/common/message_filler.h"
#include "cartographer/common/status.h"
#include "google/protobuf/message.h"

namespace cartographer::common {

absl::Status LoadOptions(const LuaFile& file, google::protobuf::Message* options) {
  ASSIGN_OR_RETURN(const LuaValue table, EvaluateLuaFile(file));
  return AddContext(FillMessage(table, options), file.path);
}

absl::Status LoadOptionsFromString(const std::string& source, const std::string& name,
                                   const std::vector<std::string>& include_directories,
                                   google::protobuf::Message* options) {
  ASSIGN_OR_RETURN(const LuaValue table, EvaluateLuaSource(source, name, include_directories));
  return AddContext(FillMessage(table, options), name);
}

absl::Status CheckOptions(const google::protobuf::Message& options, const std::string& name) {
  const std::unique_ptr<google::protobuf::Message> copy(options.New());
  return LoadOptionsFromString(OptionsToLua(options), name, {}, copy.get());
}

}  // namespace cartographer::common
