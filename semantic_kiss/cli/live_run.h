// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_LIVE_RUN_H_
#define SEMANTIC_KISS_CLI_LIVE_RUN_H_

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/cli/output_directory.h"
#include "semantic_kiss/live/board.h"
#include "semantic_kiss/live/server.h"

namespace semantic_kiss::cli {

// The page of --live, if it is asked for; else all of this does nothing.
class LiveRun {
 public:
  // `port` is the flag's value: empty for no page. Tells on standard error where the page is, also
  // with --quiet: who asked for it needs to know. Errors: no port, or one that cannot be had.
  static absl::StatusOr<std::unique_ptr<LiveRun>> Start(
      const std::string& port, const cartographer::sensor::LabelSet& labels,
      const OutputDirectory& directory);

  // nullptr without a page.
  live::Board* board() { return server_ != nullptr ? &board_ : nullptr; }

  // All scans are in.
  void Concluding();
  // The files are there. Those who look are given time to fetch the report, unless a signal asks
  // to stop.
  void End(bool complete);

 private:
  LiveRun();

  live::Board board_;
  std::unique_ptr<live::Server> server_;
};

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_LIVE_RUN_H_
