// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LIVE_LIVE_PAGE_H_
#define SEMANTIC_KISS_LIVE_LIVE_PAGE_H_

#include <string>

namespace semantic_kiss::live {

// The page, the same for every run: its script fetches what it shows. Of other files it needs none.
std::string LivePage();

}  // namespace semantic_kiss::live

#endif  // SEMANTIC_KISS_LIVE_LIVE_PAGE_H_
