// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_CLI_PROGRESS_H_
#define SEMANTIC_KISS_CLI_PROGRESS_H_

#include <functional>
#include <optional>
#include <ostream>
#include <string>

#include "semantic_kiss/cli/terminal.h"

namespace semantic_kiss::cli {

// How far a job of known size has come.
struct Progress {
  int done = 0;
  int total = 0;
  double elapsed_s = 0.;
  // Distance of the current pose from ground truth, if there is any.
  std::optional<double> error_m;
  // What else is to be told, a few words; may be empty.
  std::string note = {};
};

// One line for a terminal of `width` columns, shorter than it: a bar, per cent, count, time left,
// rate, error. What does not fit is left out, the least important first.
std::string ProgressBar(const Progress& progress, int width);

// The same as a sentence, for logs: "120/4541 scans, 31.2 scans/s, 2:21 left, error 0.43 m".
std::string ProgressLine(const Progress& progress);

// Tells a person or a log how a run over scans comes along.
class ProgressReporter {
 public:
  enum class Mode {
    kSilent,
    kLines,  // a line now and then
    kBar     // one line that is overwritten
  };

  // `now_s` is a clock: SteadySeconds, or a test's own. `terminal` is that of `out`, which outlives
  // the reporter.
  ProgressReporter(Mode mode, const Terminal& terminal, int total, std::function<double()> now_s,
                   std::ostream* out);

  ProgressReporter(const ProgressReporter&) = delete;
  ProgressReporter& operator=(const ProgressReporter&) = delete;
  // Ends the line of a bar if Finish() did not, so that an error begins a line of its own, and
  // takes back what was announced.
  ~ProgressReporter();

  // To be called after every scan; prints only when enough time went by since the last time.
  void Update(int done, std::optional<double> error_m, const std::string& note = {});

  // Prints where things ended; ends the line of a bar.
  void Finish();

  // Says what goes on after the last scan, where there was a bar, until it is called again; empty:
  // nothing any more.
  void Announce(const std::string& what);

 private:
  void Print();
  void EndBar();

  const Mode mode_;
  const Terminal terminal_;
  const std::function<double()> now_s_;
  std::ostream* const out_;
  const double started_s_;
  double printed_s_;
  bool bar_is_open_ = false;
  bool announced_ = false;
  Progress progress_;
};

// A steady clock, in seconds from an arbitrary start.
double SteadySeconds();

}  // namespace semantic_kiss::cli

#endif  // SEMANTIC_KISS_CLI_PROGRESS_H_
