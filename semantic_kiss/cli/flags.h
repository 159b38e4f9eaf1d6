// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_FLAGS_H_
#define SEMANTIC_KISS_CLI_FLAGS_H_

#include <limits>
#include <string>
#include <vector>

#include "gflags/gflags_declare.h"

// The values of all flags. A command reads only those that it declares (command.h).
DECLARE_string(box);
DECLARE_string(calib);
DECLARE_string(compare);
DECLARE_string(config);
DECLARE_string(dataset);
DECLARE_int32(epoch);
DECLARE_string(estimate);
DECLARE_int32(first_scan);
DECLARE_bool(freeze_map);
DECLARE_string(ground_truth);
DECLARE_string(hide);
DECLARE_string(initial_pose);
DECLARE_bool(json);
DECLARE_string(keep);
DECLARE_string(keep_role);
DECLARE_string(keep_trajectory);
DECLARE_double(label_noise);
DECLARE_string(labels_dir);
DECLARE_double(lane_offset);
DECLARE_double(length);
DECLARE_string(lidar);
DECLARE_string(live);
DECLARE_string(map);
DECLARE_string(map_ground_truth);
DECLARE_int32(min_hits);
DECLARE_bool(node_clouds);
DECLARE_int32(num_scans);
DECLARE_string(output);
DECLARE_string(other_map);
DECLARE_bool(outside);
DECLARE_string(polygon);
DECLARE_string(poses);
DECLARE_string(preview);
DECLARE_int32(preview_scan);
DECLARE_bool(quiet);
DECLARE_bool(raw);
DECLARE_string(remove);
DECLARE_string(remove_role);
DECLARE_bool(remove_transient);
DECLARE_double(resolution);
DECLARE_string(route);
DECLARE_int64(seed);
DECLARE_string(sequence);
DECLARE_string(show);
DECLARE_int32(threads);
DECLARE_double(speed_factor);
DECLARE_string(trace_scan);
DECLARE_string(trajectory);

namespace semantic_kiss::cli {

// Under which heading of --help a flag stands.
enum class FlagGroup { kInput, kSelection, kOutput, kExecution };

// What a value is; shells complete it accordingly.
enum class FlagValue { kText, kNumber, kFile, kDirectory, kNone };

// What is known of a flag beside its type, default and description, which gflags has.
struct FlagInfo {
  std::string name;
  std::string value_name;  // placeholder in help: "DIR"; empty for a flag without value
  FlagGroup group;
  FlagValue value;
  // How help states the default where the flag's own value would not tell ("all cores").
  std::string default_text{};
  // Smallest number that the flag may be.
  double at_least = std::numeric_limits<double>::lowest();
  // And the largest.
  double at_most = std::numeric_limits<double>::max();
  // What the flag stands for where it is given without a value; empty: it needs one.
  std::string bare_value{};
};

// All flags, in the order in which help lists them within a group.
const std::vector<FlagInfo>& Flags();

// The flag called `name`, which must exist (CHECKed: commands name only flags of ours).
const FlagInfo& FlagNamed(const std::string& name);

// The words that a flag's value may be or begin with, for shells to complete; empty if it is none
// of a few.
std::vector<std::string> WordsOfFlag(const std::string& name);

// Whether the command line sets the flag.
bool IsGiven(const std::string& flag);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_FLAGS_H_
