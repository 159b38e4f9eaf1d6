// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_COMMON_UTF8_H_
#define CARTOGRAPHER_COMMON_UTF8_H_

#include "absl/strings/string_view.h"

namespace cartographer::common {

// Whether `bytes` is well-formed UTF-8 (Unicode 15, table 3-7: no overlong forms, no surrogates,
// nothing above U+10FFFF). A protobuf `string` that is not would be written, but never read back.
bool IsUtf8(absl::string_view bytes);

}  // namespace cartographer::common

#endif  // CARTOGRAPHER_COMMON_UTF8_H_
