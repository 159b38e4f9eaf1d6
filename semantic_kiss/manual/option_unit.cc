// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/option_unit.h"

#include "absl/strings/match.h"

namespace semantic_kiss::manual {

std::string UnitOf(absl::string_view option) {
  struct Ending {
    absl::string_view text, unit;
  };
  static constexpr Ending kEndings[] = {
      {"_m_per_s2", "m/s^2"},
      {"_m_per_s", "m/s"},
      {"_m_per_m", "m per m"},
      {"_per_m", "1/m"},
      {"_deg_per_m", "deg per m"},
      {"_per_deg", "1/deg"},
      {"_per_rad", "1/rad"},
      {"_deg", "deg"},
      {"_hz", "Hz"},
      {"_mib", "MiB"},
      {"_mb", "MB"},
      {"_px", "px"},
      {"_m", "m"},
      {"_s", "s"},
  };
  const Ending* best = nullptr;
  for (const Ending& ending : kEndings) {
    if (!absl::EndsWith(option, ending.text)) continue;
    if (best == nullptr || ending.text.size() > best->text.size()) best = &ending;
  }
  return best == nullptr ? "" : std::string(best->unit);
}

}  // namespace semantic_kiss::manual
