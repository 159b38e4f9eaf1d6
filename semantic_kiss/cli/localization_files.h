// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_LOCALIZATION_FILES_H_
#define SEMANTIC_KISS_CLI_LOCALIZATION_FILES_H_

#include <string>

#include "absl/status/status.h"
#include "cartographer/transform/rigid_transform.h"
#include "nlohmann/json.hpp"
#include "semantic_kiss/cli/localization.h"
#include "semantic_kiss/cli/output_directory.h"

namespace semantic_kiss::cli {

// What relocalization.json tells beside the drive itself.
struct LocalizationContext {
  std::string configuration_lua;
  std::string map_file;
  std::string map_sha256_before, map_sha256_after;
  double map_loading_s = 0.;
  int scans_available = 0;
  std::optional<cartographer::transform::Rigid3d> camera_from_sensor;
};

// relocalization_kitti.txt, relocalization_tum.txt, smoothed_tum.txt, relocalization.json.
absl::Status WriteLocalizationFiles(const OutputDirectory& directory,
                                    const Localization& localization,
                                    const LocalizationContext& context);

nlohmann::ordered_json LocalizationJson(const Localization& localization,
                                        const LocalizationContext& context);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_LOCALIZATION_FILES_H_
