// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_MAP_REPORT_H_
#define SEMANTIC_KISS_CLI_MAP_REPORT_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/io/proto/render_options.pb.h"
#include "cartographer/map/map.h"
#include "semantic_kiss/report/proto/report_options.pb.h"
#include "semantic_kiss/report/report.h"

namespace semantic_kiss::cli {

struct NamedMap {
  std::string name;
  cartographer::map::Map map;  // clouds of nodes are not needed
};

// A page about maps, several of them side by side: what they look like, what is in them. At least
// one (CHECKed). Errors are those of report::TakeApart().
absl::StatusOr<report::Report> MapReport(const std::vector<NamedMap>& maps,
                                         const cartographer::io::proto::RenderOptions& image,
                                         const report::proto::ReportOptions& options);

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_MAP_REPORT_H_
