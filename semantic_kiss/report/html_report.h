// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_HTML_REPORT_H_
#define SEMANTIC_KISS_REPORT_HTML_REPORT_H_

#include <string>

#include "semantic_kiss/report/report.h"

namespace semantic_kiss::report {

// The report as one HTML file that needs no other and no network: pictures, styles and scripts are
// inside, and the page forbids itself to load anything. The same report gives the same bytes.
std::string Html(const Report& report);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_HTML_REPORT_H_
