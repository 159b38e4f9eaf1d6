// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_FLAG_TEXT_H_
#define SEMANTIC_KISS_CLI_FLAG_TEXT_H_

#include <string>
#include <vector>

#include "semantic_kiss/cli/command.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {

// What --help and the manual page say of flags, the same words in both.

// What semantic_kiss is, in a sentence.
extern const char kProgramSummary[];

// What exit codes mean, in a sentence.
extern const char kExitCodes[];

// All groups in the order in which they are listed, and the heading of one.
std::vector<FlagGroup> FlagGroups();
const char* Heading(FlagGroup group);

// "--dataset=DIR"; "--quiet" of a flag without value.
std::string FlagTerm(const FlagInfo& flag);

// Description, and in brackets that it is required or what it is by default.
std::string FlagMeaning(const FlagInfo& flag, const FlagUse& use);

// The uses of a command that belong to a group, in the order of Flags().
std::vector<FlagUse> UsesOfGroup(const Command& command, FlagGroup group);

// The command with the flags that it needs: "run --dataset=DIR --output=PATH".
std::string ShortestUse(const Command& command);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_FLAG_TEXT_H_
