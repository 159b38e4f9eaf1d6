// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_MANUAL_SHELL_COMPLETION_H_
#define SEMANTIC_KISS_MANUAL_SHELL_COMPLETION_H_

#include <string>
#include <vector>

#include "semantic_kiss/cli/command.h"

namespace semantic_kiss::manual {

// Scripts by which shells complete commands, their flags, and the values of flags: files, folders,
// configurations that the program brings along, words.

// For bash 4.4 and later, to be sourced or put among bash-completion's files.
std::string BashCompletion(const std::vector<cli::Command>& commands);

// For zsh: a file _semantic_kiss in a directory of $fpath.
std::string ZshCompletion(const std::vector<cli::Command>& commands);

}  // namespace semantic_kiss::manual

#endif  // SEMANTIC_KISS_MANUAL_SHELL_COMPLETION_H_
