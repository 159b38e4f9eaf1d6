// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/trace_text.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace semantic_kiss::cli {
namespace {

using cartographer::sensor::Label;
using cartographer::sensor::LabelSet;
using cartographer::slam::PointsByLabel;
using cartographer::slam::TraceStep;
using Json = nlohmann::ordered_json;

constexpr size_t kLabelsTold = 6;
constexpr int kIndent = 4;
// Where the last column begins: the sum of the widths before.
constexpr int kOutcomeColumn = 53;
constexpr int kMinWidth = 80;
constexpr int kMaxWidth = 120;

std::string Count(const std::optional<size_t>& count) {
  return count.has_value() ? absl::StrCat(*count) : "-";
}

// "road 21034, building 9932, 3 more".
std::string LabelsText(const PointsByLabel& counts, const LabelSet& labels) {
  std::vector<std::pair<Label, size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (size_t i = 0; i < std::min(sorted.size(), kLabelsTold); ++i) {
    absl::StrAppend(&text, i == 0 ? "" : ", ", labels.Name(sorted[i].first), " ", sorted[i].second);
  }
  if (sorted.size() > kLabelsTold) {
    absl::StrAppend(&text, ", ", sorted.size() - kLabelsTold, " more");
  }
  return text;
}

std::string Milliseconds(const TraceStep& step) {
  if (step.seconds.has_value()) return absl::StrFormat("%.2f", 1e3 * *step.seconds);
  return step.points_in.has_value() ? "\"" : "-";
}

std::string StepText(const TraceStep& step, const LabelSet& labels, const Terminal& terminal,
                     int width) {
  std::string text =
      absl::StrFormat("  %-15s%-8s%9s%9s%9s ", step.stage, step.frame, Count(step.points_in),
                      Count(step.points_out), Milliseconds(step));
  absl::StrAppend(&text, Wrapped(step.outcome, kOutcomeColumn, width).substr(kOutcomeColumn), "\n");
  if (step.labels.empty()) return text;
  return absl::StrCat(
      text, Styled(terminal, Style::kDim, Wrapped(LabelsText(step.labels, labels), kIndent, width)),
      "\n");
}

Json OrNull(const std::optional<size_t>& count) { return count ? Json(*count) : Json(); }

Json StepJson(const TraceStep& step, const LabelSet& labels) {
  Json counts = Json::object();
  for (const auto& [label, count] : step.labels) counts[labels.Name(label)] = count;
  return {{"stage", step.stage},
          {"frame", step.frame},
          {"outcome", step.outcome},
          {"from", step.from.empty() ? Json() : Json(step.from)},
          {"points_in", OrNull(step.points_in)},
          {"points_out", OrNull(step.points_out)},
          {"labels", std::move(counts)},
          {"ms", step.seconds ? Json(1e3 * *step.seconds) : Json()}};
}

}  // namespace

std::string TraceText(const TracedScan& traced, const LabelSet& labels, const Terminal& terminal) {
  const int width =
      terminal.interactive ? std::clamp(terminal.width, kMinWidth, kMaxWidth) : kMaxWidth;
  std::string text =
      Styled(terminal, Style::kBold, absl::StrCat("The way of scan ", traced.number)) + "\n";
  text += Styled(terminal, Style::kDim,
                 absl::StrFormat("  %-15s%-8s%9s%9s%9s %s", "stage", "frame", "points in", "out",
                                 "ms", "outcome; below it the labels")) +
          "\n";
  for (const TraceStep& step : traced.steps) text += StepText(step, labels, terminal, width);
  return text + "\n";
}

Json TraceJson(const TracedScan& traced, const LabelSet& labels) {
  Json steps = Json::array();
  for (const TraceStep& step : traced.steps) steps.push_back(StepJson(step, labels));
  return {{"scan", traced.number}, {"node", traced.is_node}, {"steps", std::move(steps)}};
}

}  // namespace semantic_kiss::cli
