// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <vector>

#include "glog/logging.h"
#include "semantic_kiss/cli/program.h"
#include "semantic_kiss/cli/stop_signals.h"

int main(int argc, char** argv) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_WARNING;
  google::InitGoogleLogging(argv[0]);
  semantic_kiss::cli::WatchStopSignals();
  return semantic_kiss::cli::RunProgram(std::vector<std::string>(argv + 1, argv + argc));
}
