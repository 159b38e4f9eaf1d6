// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/run_text.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"

namespace semantic_kiss::cli {

std::string ScansText(const RunResult& result) {
  if (result.drive.num_scans == result.scans_available) return absl::StrCat(result.drive.num_scans);
  return absl::StrCat(result.drive.num_scans, " of ", result.scans_available, " (stopped)");
}

std::string OutcomesText(const DriveRecord& drive) {
  return absl::StrJoin(drive.outcomes, ", ", [](std::string* out, const auto& outcome) {
    absl::StrAppend(out, outcome.second, " ", outcome.first);
  });
}

std::string UnknownLabelsText(const dataset::UnknownLabelIds& ids) {
  return absl::StrJoin(ids, ", ", [](std::string* out, const auto& id) {
    absl::StrAppend(out, "id ", id.first, ": ", id.second, " points");
  });
}

std::string FigureText(const std::optional<double>& value, int decimals, const char* unit) {
  if (!value.has_value()) return "-";
  const std::string number = absl::StrFormat("%.*f", decimals, *value);
  return *unit == '\0' ? number : absl::StrCat(number, " ", unit);
}

double ScansPerSecond(const DriveRecord& drive) {
  return drive.elapsed_s > 0. ? drive.num_scans / drive.elapsed_s : 0.;
}

}  // namespace semantic_kiss::cli
