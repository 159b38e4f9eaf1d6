// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/report/page_files.h"

#include "glog/logging.h"
#include "semantic_kiss/report/embedded_files.h"

namespace semantic_kiss::report {

std::string PageFile(absl::string_view name) {
  for (const EmbeddedFile& file : kEmbeddedFiles) {
    if (name == file.name) return file.content;
  }
  LOG(FATAL) << "no file of the page is called " << name;
}

}  // namespace semantic_kiss::report
