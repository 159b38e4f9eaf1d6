// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"

namespace semantic_kiss::cli {
namespace {

constexpr double kSecondsBetweenBars = 0.1;
constexpr double kSecondsBetweenLines = 5.;
constexpr int kMinBarWidth = 10;
constexpr int kMaxBarWidth = 40;

double Rate(const Progress& progress) {
  return progress.elapsed_s > 0. ? progress.done / progress.elapsed_s : 0.;
}

double Fraction(const Progress& progress) {
  return progress.total > 0 ? static_cast<double>(progress.done) / progress.total : 1.;
}

std::string TimeLeft(const Progress& progress) {
  const double rate = Rate(progress);
  if (rate <= 0.) return "?";
  const auto seconds = static_cast<int64_t>(std::ceil((progress.total - progress.done) / rate));
  if (seconds < 3600) return absl::StrFormat("%d:%02d", seconds / 60, seconds % 60);
  return absl::StrFormat("%d:%02d:%02d", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string Bar(double fraction, int width) {
  const int inside = width - 2;
  const int filled = static_cast<int>(fraction * inside);
  return absl::StrCat("[", std::string(filled, '='), std::string(inside - filled, ' '), "]");
}

}  // namespace

std::string ProgressBar(const Progress& progress, int width) {
  // The most important first; a terminal's last column stays free, as some wrap there.
  std::vector<std::string> parts = {
      absl::StrFormat("%3d%%", static_cast<int>(100. * Fraction(progress))),
      absl::StrCat(progress.done, "/", progress.total),
      absl::StrCat("ETA ", TimeLeft(progress)),
      absl::StrFormat("%.1f/s", Rate(progress)),
  };
  if (progress.error_m.has_value()) {
    parts.push_back(absl::StrFormat("odometry off by %.2f m", *progress.error_m));
  }
  if (!progress.note.empty()) parts.insert(parts.begin() + 1, progress.note);
  std::string line = absl::StrJoin(parts, " ");
  while (parts.size() > 1 && static_cast<int>(line.size()) >= width) {
    parts.pop_back();
    line = absl::StrJoin(parts, " ");
  }
  const int room = std::min(width - 2 - static_cast<int>(line.size()), kMaxBarWidth);
  if (room >= kMinBarWidth) line = absl::StrCat(Bar(Fraction(progress), room), " ", line);
  return line.substr(0, std::max(width - 1, 0));
}

std::string ProgressLine(const Progress& progress) {
  std::string line = absl::StrFormat("%d/%d scans, %.1f scans/s, %s left", progress.done,
                                     progress.total, Rate(progress), TimeLeft(progress));
  if (progress.error_m.has_value()) {
    absl::StrAppendFormat(&line, ", odometry off by %.2f m", *progress.error_m);
  }
  if (!progress.note.empty()) absl::StrAppend(&line, ", ", progress.note);
  return line;
}

ProgressReporter::ProgressReporter(Mode mode, const Terminal& terminal, int total,
                                   std::function<double()> now_s, std::ostream* out)
    : mode_(mode),
      terminal_(terminal),
      now_s_(std::move(now_s)),
      out_(out),
      started_s_(now_s_()),
      printed_s_(started_s_) {
  progress_.total = total;
}

void ProgressReporter::Update(int done, std::optional<double> error_m, const std::string& note) {
  progress_.done = done;
  progress_.note = note;
  progress_.error_m = error_m;
  const double now_s = now_s_();
  progress_.elapsed_s = now_s - started_s_;
  if (now_s - printed_s_ < (mode_ == Mode::kBar ? kSecondsBetweenBars : kSecondsBetweenLines)) {
    return;
  }
  printed_s_ = now_s;
  Print();
}

void ProgressReporter::Finish() {
  Print();
  EndBar();
}

void ProgressReporter::Announce(const std::string& what) {
  if (mode_ != Mode::kBar || (what.empty() && !announced_)) return;
  EndBar();
  *out_ << "\r" << what.substr(0, std::max(terminal_.width - 1, 0)) << "\033[K" << std::flush;
  announced_ = !what.empty();
}

ProgressReporter::~ProgressReporter() {
  EndBar();
  Announce("");
}

void ProgressReporter::EndBar() {
  if (bar_is_open_) *out_ << std::endl;
  bar_is_open_ = false;
}

void ProgressReporter::Print() {
  switch (mode_) {
    case Mode::kSilent:
      break;
    case Mode::kLines:
      *out_ << ProgressLine(progress_) << std::endl;
      break;
    case Mode::kBar:
      // "\033[K" clears what a longer line left behind.
      *out_ << "\r" << ProgressBar(progress_, terminal_.width) << "\033[K" << std::flush;
      bar_is_open_ = true;
      break;
  }
}

double SteadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace semantic_kiss::cli
