// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/shipped_options.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/options_loader.h"
#include "cartographer/common/status.h"
#include "cartographer/map/proto/filter_options.pb.h"
#include "semantic_kiss/cli/proto/run_options.pb.h"
#include "semantic_kiss/simulation/proto/simulation_options.pb.h"

namespace semantic_kiss::manual {
namespace {

namespace fs = std::filesystem;

template <typename Options>
absl::StatusOr<OptionFile> Load(const std::string& name, const std::string& lua,
                                const std::string& directory) {
  OptionFile file{name, std::make_unique<Options>()};
  RETURN_IF_ERROR(
      cartographer::common::LoadOptionsFromString(lua, name, {directory}, file.options.get()));
  return file;
}

// The files that return the options of a run are the systems; others do not load as such, which
// the tests of the files themselves tell from a mistake in one.
absl::StatusOr<std::vector<OptionFile>> LoadSystems(const std::string& directory) {
  std::vector<OptionFile> systems;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".lua") continue;
    auto file = Load<cli::proto::RunOptions>(name, absl::StrCat("return include \"", name, "\""),
                                             directory);
    if (file.ok()) systems.push_back(*std::move(file));
  }
  if (systems.empty()) {
    return absl::NotFoundError(absl::StrCat(directory, ": holds no configuration of a run"));
  }
  std::sort(systems.begin(), systems.end(),
            [](const OptionFile& a, const OptionFile& b) { return a.name < b.name; });
  return systems;
}

}  // namespace

absl::StatusOr<std::vector<OptionTree>> LoadShippedOptions(const std::string& directory) {
  std::vector<OptionTree> trees(3);
  trees[0].commands = "`run`, `relocalize`, `merge`, `render`";
  trees[0].example =
      "include \"semantic_kiss_6dof.lua\"\nRUN.pose_graph.optimization.dof = 3\nreturn RUN\n";
  ASSIGN_OR_RETURN(trees[0].defaults,
                   Load<cli::proto::RunOptions>(
                       "defaults/run.lua", "include \"defaults/run.lua\"\nreturn RUN", directory));
  ASSIGN_OR_RETURN(trees[0].systems, LoadSystems(directory));

  trees[1].commands = "`filter`";
  trees[1].example =
      "include \"defaults/map_filter.lua\"\nMAP_FILTER.remove_roles = { \"movable\" }\n"
      "return MAP_FILTER\n";
  ASSIGN_OR_RETURN(trees[1].defaults,
                   Load<cartographer::map::proto::FilterOptions>(
                       "filter.lua", "return include \"filter.lua\"", directory));

  trees[2].commands = "`simulate`";
  trees[2].example =
      "local options = include \"simulation.lua\"\noptions.world.person_density = 0\n"
      "return options\n";
  ASSIGN_OR_RETURN(trees[2].defaults,
                   Load<simulation::proto::SimulationOptions>(
                       "simulation.lua", "return include \"simulation.lua\"", directory));
  return trees;
}

}  // namespace semantic_kiss::manual
