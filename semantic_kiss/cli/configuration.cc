// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/configuration.h"

#include <filesystem>
#include <set>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/nearest_name.h"
#include "cartographer/common/options_loader.h"
#include "cartographer/common/status.h"
#include "cartographer/io/hidden_labels.h"

namespace semantic_kiss::cli {
namespace {

namespace fs = std::filesystem;
using cartographer::common::AddContext;
using cartographer::sensor::LabelSet;
using Directories = std::vector<std::string>;

absl::StatusOr<LabelSet> LoadLabelSet(const std::string& name, const Directories& directories) {
  ASSIGN_OR_RETURN(const std::string path, cartographer::common::FindLuaFile(
                                               absl::StrCat("labels/", name, ".lua"), directories));
  return LabelSet::Load({path, directories});
}

// The path of a configuration file that exists.
absl::StatusOr<std::string> FindConfiguration(const std::string& file,
                                              const std::string& installed) {
  absl::StatusOr<std::string> path = cartographer::common::FindLuaFile(file, {"", installed});
  if (!absl::IsNotFound(path.status())) return path;
  std::error_code ignored;
  std::set<std::string> names;  // in order
  for (const auto& entry : fs::directory_iterator(installed, ignored)) {
    if (entry.path().extension() == ".lua") names.insert(entry.path().filename().string());
  }
  return absl::NotFoundError(
      absl::StrCat(path.status().message(), "; ",
                   cartographer::common::SuggestName(
                       file, std::vector<std::string>(names.begin(), names.end()))));
}

}  // namespace

std::string InstalledConfigurationDirectory() {
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  return (executable.parent_path().parent_path() / "share/semantic_kiss/configuration_files")
      .string();
}

absl::StatusOr<Configuration> LoadConfiguration(const std::string& file) {
  const std::string installed = InstalledConfigurationDirectory();
  ASSIGN_OR_RETURN(const std::string path, FindConfiguration(file, installed));
  const Directories directories = {fs::path(path).parent_path().string(), installed};
  Configuration configuration;
  RETURN_IF_ERROR(cartographer::common::LoadOptions({path, directories}, &configuration.options));
  absl::StatusOr<LabelSet> labels = LoadLabelSet(configuration.options.label_set(), directories);
  if (!labels.ok()) return AddContext(labels.status(), absl::StrCat(path, ": label_set"));
  configuration.labels = *std::move(labels);
  const auto hidden =
      cartographer::io::HiddenLabels(configuration.options.map_image(), configuration.labels);
  RETURN_IF_ERROR(AddContext(hidden.status(), absl::StrCat(path, ": map_image")));
  configuration.lua = cartographer::common::OptionsToLua(configuration.options);
  return configuration;
}

}  // namespace semantic_kiss::cli
