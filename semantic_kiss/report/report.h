// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_REPORT_REPORT_H_
#define SEMANTIC_KISS_REPORT_REPORT_H_

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "semantic_kiss/report/map_layers.h"

namespace semantic_kiss::report {

// All that a page says, as plain values; text is plain, too: it is escaped where HTML needs it.

// A number that is to be seen first.
struct Figure {
  std::string name;
  std::string value;
  std::string unit;
  std::string note;  // what it means, in a few words
};

struct Table {
  std::string heading;
  std::string note;                 // a sentence below the heading; may be empty
  std::vector<std::string> header;  // empty: the table has none
  std::vector<std::vector<std::string>> rows;
};

// Whose line it is: each has a colour of its own, the same in maps and charts.
enum class Role { kTrajectory, kOdometry, kGroundTruth, kEarlierDrive };

struct Path {
  std::string name;
  Role role = Role::kTrajectory;
  std::vector<Eigen::Vector2d> positions;  // [m], map frame
};

// A quantity along the first path of a map, by which the path can be coloured: one value for each
// of its positions.
struct Coloring {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

struct ClosureMark {
  Eigen::Vector2d node, submap;    // [m], map frame: the ends of the line
  std::optional<bool> right;       // known with ground truth only
  std::vector<std::string> facts;  // one for each of closure_facts or rejected_facts
};

// A map to look at, with what was driven in it.
struct MapView {
  std::string caption;
  MapLayers layers;
  std::vector<Path> paths;
  std::vector<Coloring> colorings;
  std::vector<std::string> closure_facts;  // names: "score", "overlap", ...
  std::vector<ClosureMark> closures;
  std::vector<std::string> rejected_facts;
  std::vector<ClosureMark> rejected;  // what might have been closures
};

struct Series {
  std::string name;
  Role role = Role::kTrajectory;
  std::vector<double> values;
};

struct Chart {
  enum class Kind {
    kLine,     // over `x`
    kColumns,  // upright bars, grouped by `categories`
    kRows      // lying bars, one for each of `categories`
  };
  std::string heading;
  std::string note;
  Kind kind = Kind::kLine;
  std::string x_name, y_name;  // with units
  std::vector<double> x;
  std::vector<std::string> categories;
  std::vector<Series> series;  // as long as `x` or `categories`
  // Values belong to the positions of the first map's first path: pointing at one shows the other.
  bool along_path = false;
};

struct Report {
  std::string title;
  std::string subtitle;
  std::vector<Figure> figures;
  std::vector<MapView> maps;  // several: side by side, moved together
  std::vector<Chart> charts;
  std::vector<Table> tables;
  std::string code_heading;
  std::string code;  // shown as it is, folded away
};

}  // namespace semantic_kiss::report

#endif  // SEMANTIC_KISS_REPORT_REPORT_H_
