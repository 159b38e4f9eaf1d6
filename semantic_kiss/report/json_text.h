// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_JSON_TEXT_H_
#define SEMANTIC_KISS_REPORT_JSON_TEXT_H_

#include <nlohmann/json.hpp>
#include <string>

namespace semantic_kiss::report {

// JSON on one line, or with lines indented by so many spaces a level. Names of files and histories
// of maps need not be UTF-8: what is wrong in them becomes U+FFFD.
inline std::string JsonText(const nlohmann::ordered_json& json, int indent = -1) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_JSON_TEXT_H_
