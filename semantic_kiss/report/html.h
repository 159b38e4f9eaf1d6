// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_HTML_H_
#define SEMANTIC_KISS_REPORT_HTML_H_

#include <map>
#include <string>

#include "absl/strings/string_view.h"

namespace semantic_kiss::report {

// Plain text as HTML, fit for content and for values of attributes.
std::string Escaped(absl::string_view text);

// JSON as the content of a script element, which no text in it can end.
std::string JsonForScript(absl::string_view json);

// Replaces each {{name}} of a template by what `values` has under that name; what is put in is not
// searched again. A name without a value, or a {{ without }}, is a bug (CHECKed).
std::string FillTemplate(absl::string_view text, const std::map<std::string, std::string>& values);

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_HTML_H_
