// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_PAGE_FILES_H_
#define SEMANTIC_KISS_REPORT_PAGE_FILES_H_

#include <string>

#include "absl/strings/string_view.h"

namespace semantic_kiss::report {

// The content of a file of page/, or of one of Leaflet's: part of the program since it was built
// (cmake/EmbedFiles.cmake), so that pages need nothing that is installed. A name that there is not
// is a bug (CHECKed).
std::string PageFile(absl::string_view name);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_PAGE_FILES_H_
