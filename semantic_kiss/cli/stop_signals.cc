// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/stop_signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "cartographer/io/atomic_file.h"

namespace semantic_kiss::cli {
namespace {

std::atomic<bool> in_good_order{false};
std::atomic<int> signal_received{0};

// A thread that waits, not a handler: it may take locks and remove files.
[[noreturn]] void Watch(sigset_t signals) {
  while (true) {
    int signal = 0;
    if (sigwait(&signals, &signal) != 0) continue;
    if (in_good_order && signal_received.exchange(signal) == 0) continue;
    cartographer::io::AbandonAtomicFiles();
    _exit(128 + signal);
  }
}

}  // namespace

void WatchStopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(Watch, signals).detach();
}

void StopInGoodOrder() { in_good_order = true; }

bool StopRequested() { return signal_received != 0; }

int StopExitCode() { return 128 + signal_received; }

}  // namespace semantic_kiss::cli
