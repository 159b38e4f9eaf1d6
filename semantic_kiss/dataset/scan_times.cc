// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/scan_times.h"

#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "cartographer/common/status.h"
#include "semantic_kiss/dataset/file_buffer.h"

namespace semantic_kiss::dataset {
namespace {

using cartographer::common::FromUnixSeconds;
using cartographer::common::Time;

// The year 2286: seconds beyond it are some other unit.
constexpr double kMaxSeconds = 1e10;

absl::StatusOr<Time> ParseTime(absl::string_view line) {
  double seconds;
  if (!absl::SimpleAtod(line, &seconds)) {
    return absl::InvalidArgumentError(
        absl::StrCat("\"", absl::CHexEscape(absl::StripAsciiWhitespace(line).substr(0, 40)),
                     "\" is not a time; one number is needed, the seconds of the scan"));
  }
  if (!(seconds >= 0. && seconds <= kMaxSeconds)) {
    return absl::InvalidArgumentError(absl::StrCat("the time is ", seconds, "; seconds from 0 to ",
                                                   kMaxSeconds, " are expected"));
  }
  return FromUnixSeconds(seconds);
}

}  // namespace

absl::StatusOr<std::vector<Time>> ReadScanTimes(const std::string& path) {
  FileBuffer buffer;
  RETURN_IF_ERROR(buffer.Read(path));
  std::vector<Time> times;
  const absl::string_view text = absl::StripTrailingAsciiWhitespace(buffer.text());
  if (text.empty()) return times;
  for (const absl::string_view line : absl::StrSplit(text, '\n')) {
    const absl::StatusOr<Time> time = ParseTime(line);
    const std::string where = absl::StrCat(path, ":", times.size() + 1);
    if (!time.ok()) return cartographer::common::AddContext(time.status(), where);
    if (!times.empty() && *time <= times.back()) {
      return absl::InvalidArgumentError(absl::StrCat(
          where, ": the time is ", absl::StripAsciiWhitespace(line),
          ", not later than that of the line before; times must increase, by 100 ns at least"));
    }
    times.push_back(*time);
  }
  return times;
}

}  // namespace semantic_kiss::dataset
