// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/html.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "glog/logging.h"

namespace semantic_kiss::report {

std::string Escaped(absl::string_view text) {
  return absl::StrReplaceAll(
      text, {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"'", "&#39;"}});
}

std::string JsonForScript(absl::string_view json) {
  return absl::StrReplaceAll(json, {{"<", "\\u003c"}});
}

std::string FillTemplate(absl::string_view text, const std::map<std::string, std::string>& values) {
  std::string result;
  while (true) {
    const size_t begin = text.find("{{");
    absl::StrAppend(&result, text.substr(0, begin));
    if (begin == absl::string_view::npos) return result;
    const size_t end = text.find("}}", begin);
    CHECK_NE(end, absl::string_view::npos) << "a {{ without }}";
    const auto value = values.find(std::string(text.substr(begin + 2, end - begin - 2)));
    CHECK(value != values.end()) << "no value for " << text.substr(begin, end + 2 - begin);
    absl::StrAppend(&result, value->second);
    text.remove_prefix(end + 2);
  }
}

}  // namespace semantic_kiss::report
