// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_TESTING_SHIPPED_OPTIONS_H_
#define TEST_TESTING_SHIPPED_OPTIONS_H_

#include <cstdlib>
#include <string>

#include "absl/strings/str_cat.h"
#include "cartographer/common/options_loader.h"
#include "glog/logging.h"

namespace semantic_kiss_testing {

// What the table `table` of configuration_files/defaults/`name`.lua says, after `changes` to it in
// Lua. CHECKs that it can be loaded.
template <typename Options>
Options ShippedOptions(const std::string& name, const std::string& table,
                       const std::string& changes = "") {
  const char* const source_directory = std::getenv("SEMANTIC_KISS_SOURCE_DIR");
  const std::string root = source_directory == nullptr ? "." : source_directory;
  const std::string lua =
      absl::StrCat("include \"defaults/", name, ".lua\"\n", changes, "\nreturn ", table);
  Options options;
  const absl::Status status = cartographer::common::LoadOptionsFromString(
      lua, "test", {absl::StrCat(root, "/configuration_files")}, &options);
  CHECK(status.ok()) << status;
  return options;
}

}  // namespace semantic_kiss_testing

#endif  // TEST_TESTING_SHIPPED_OPTIONS_H_
