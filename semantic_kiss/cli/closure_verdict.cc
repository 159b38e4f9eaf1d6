// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/closure_verdict.h"

#include <map>

namespace semantic_kiss::cli {

std::string MeaningOf(const std::string& verdict) {
  static const auto& meanings = *new std::map<std::string, std::string>{
      {"accepted", "became a loop closure"},
      {"no_match", "no pose in the plane scored well enough"},
      {"no_agreement", "no other closure nearby said the same"},
      {"icp_failed", "could not be registered in space"},
      {"too_few_points", "too little that both saw"},
      {"low_overlap", "much of what the scan saw is not there"},
      {"low_inlier_ratio", "what is there has another shape or other labels"},
      {"large_error", "nearly fits, but not as the same place would"},
      {"large_correction", "registration in space contradicts the match in the plane"},
      {"height_mismatch", "the grounds do not meet"},
      {"degenerate", "the surroundings leave a direction open"}};
  const auto found = meanings.find(verdict);
  return found == meanings.end() ? "" : found->second;
}

}  // namespace semantic_kiss::cli
