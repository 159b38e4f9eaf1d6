// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/program.h"

#include <unistd.h>

#include <exception>
#include <iostream>
#include <new>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "semantic_kiss/cli/arguments.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/flags.h"
#include "semantic_kiss/cli/help.h"
#include "semantic_kiss/cli/stop_signals.h"
#include "semantic_kiss/cli/terminal.h"
#include "semantic_kiss/cli/version.h"
#include "tbb/global_control.h"
#include "tbb/info.h"
#include "tbb/task_arena.h"

namespace semantic_kiss::cli {
namespace {

// One line, whatever the message (a file's name may hold a newline).
void PrintProblem(const char* kind, Style style, absl::string_view message) {
  std::cerr << Styled(Terminal::Of(STDERR_FILENO), style, kind) << ": "
            << absl::StrReplaceAll(message, {{"\n", " "}}) << std::endl;
}

// Here alone threads are counted: libraries use what the arena gives them.
absl::Status RunInArena(const Command& command) {
  const int threads = FLAGS_threads > 0 ? FLAGS_threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  return arena.execute([&] { return command.run(); });
}

// Input may be wrong in ways that no check foresaw, above all larger than memory: that is the
// user's to know as well, in one line.
absl::Status RunGuarded(const Command& command) {
  try {
    return RunInArena(command);
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError(
        "there is not enough memory; take fewer scans, larger cells or a smaller map");
  } catch (const std::exception& exception) {
    return absl::InternalError(absl::StrCat(command.name, " failed: ", exception.what()));
  }
}

int Execute(const Command& command) {
  const absl::Status status = RunGuarded(command);
  std::cout.flush();
  if (status.ok() && std::cout) return kExitDone;
  if (status.ok()) {
    PrintProblem("error", Style::kRed, "cannot write to the standard output; is the disk full?");
    return kExitFailed;
  }
  if (absl::IsCancelled(status) && StopRequested()) {
    PrintProblem("stopped", Style::kYellow, status.message());
    return StopExitCode();
  }
  PrintProblem("error", Style::kRed, status.message());
  return kExitFailed;
}

}  // namespace

int RunProgram(const std::vector<std::string>& arguments) {
  const absl::StatusOr<Invocation> invocation = ParseArguments(Commands(), arguments);
  if (!invocation.ok()) {
    PrintProblem("error", Style::kRed, invocation.status().message());
    return kExitUsage;
  }
  switch (invocation->kind) {
    case Invocation::Kind::kVersion:
      std::cout << "semantic_kiss " << Version() << std::endl;
      return kExitDone;
    case Invocation::Kind::kHelp: {
      const Terminal terminal = Terminal::Of(STDOUT_FILENO);
      std::cout << (invocation->command == nullptr ? OverviewHelp(Commands(), terminal)
                                                   : CommandHelp(*invocation->command, terminal))
                << std::flush;
      return kExitDone;
    }
    case Invocation::Kind::kRun:
      return Execute(*invocation->command);
  }
  return kExitUsage;
}

}  // namespace semantic_kiss::cli
