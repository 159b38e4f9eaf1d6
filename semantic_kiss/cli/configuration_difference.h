// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_CONFIGURATION_DIFFERENCE_H_
#define SEMANTIC_KISS_CLI_CONFIGURATION_DIFFERENCE_H_

#include <string>
#include <vector>

namespace semantic_kiss::cli {

struct ConfigurationDifference {
  std::string key;           // whole path: "pose_graph.optimization.dof"
  std::string value, other;  // as Lua; empty: there is none
};

// Where two configurations differ, both as common::OptionsToLua() writes them: in the order of
// `lua`, then what `other` alone has. Lists on one line are values; longer ones differ element by
// element ("confidence_columns[2]").
std::vector<ConfigurationDifference> Differences(const std::string& lua, const std::string& other);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_CONFIGURATION_DIFFERENCE_H_
