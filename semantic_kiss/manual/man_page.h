// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_MANUAL_MAN_PAGE_H_
#define SEMANTIC_KISS_MANUAL_MAN_PAGE_H_

#include <string>
#include <vector>

#include "absl/strings/string_view.h"
#include "semantic_kiss/cli/command.h"

namespace semantic_kiss::manual {

// semantic_kiss(1) in the macros of man(7): all commands with all that --help tells about them.
std::string ManPage(const std::vector<cli::Command>& commands, absl::string_view version);

// Text so that roff shows it as it is: backslashes, hyphens of flags, dots and quotes that would
// begin a request.
std::string RoffText(absl::string_view text);

}  // namespace semantic_kiss::manual

#endif  // SEMANTIC_KISS_MANUAL_MAN_PAGE_H_
