// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/live_run.h"

#include <iostream>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "semantic_kiss/cli/progress.h"
#include "semantic_kiss/cli/stop_signals.h"

namespace semantic_kiss::cli {
namespace {

constexpr int kMaxPort = 65535;

}  // namespace

LiveRun::LiveRun() : board_(&SteadySeconds) {}

absl::StatusOr<std::unique_ptr<LiveRun>> LiveRun::Start(
    const std::string& port, const cartographer::sensor::LabelSet& labels,
    const OutputDirectory& directory) {
  std::unique_ptr<LiveRun> run(new LiveRun);
  if (port.empty()) return run;
  int number = 0;
  if (!absl::SimpleAtoi(port, &number) || number < 0 || number > kMaxPort) {
    return absl::InvalidArgumentError(absl::StrCat("--live=", port, " is no port; take one up to ",
                                                   kMaxPort, ", or none for any that is free"));
  }
  ASSIGN_OR_RETURN(run->server_, live::Server::Start(number, &run->board_, labels,
                                                     directory.FileNamed("report.html")));
  std::cerr << "live at " << run->server_->url() << std::endl;
  return run;
}

void LiveRun::Concluding() { board_.SetPhase(live::Phase::kConcluding); }

void LiveRun::End(bool complete) {
  if (server_ == nullptr) return;
  // Of a run that was stopped a signal was seen already: its page has the report, too.
  const bool was_stopped = StopRequested();
  server_->Conclude(complete ? live::Phase::kDone : live::Phase::kStopped,
                    [=] { return StopRequested() && !was_stopped; });
}

}  // namespace semantic_kiss::cli
