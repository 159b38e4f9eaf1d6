// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef TEST_CARTOGRAPHER_SCAN_MATCHING_SMALL_SCENES_H_
#define TEST_CARTOGRAPHER_SCAN_MATCHING_SMALL_SCENES_H_

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "cartographer/scan_matching/matching_scan.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/scan_matching/score_model.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/submap/semantic_grid.h"

namespace cartographer::scan_matching {

// unlabeled 0, car 1 (movable), road 2 and sidewalk 3 (ground), building 4, vegetation 5, pole 6
// and sign 7 (critical), moving-car 8 (moving).
inline sensor::LabelSet SmallLabelSet() {
  sensor::proto::LabelSet declaration;
  declaration.set_name("small");
  declaration.set_default_certainty(1.);
  const std::pair<const char*, const char*> classes[] = {
      {"unlabeled", "unlabeled"}, {"car", "movable"},   {"road", "ground"},
      {"sidewalk", "ground"},     {"building", ""},     {"vegetation", ""},
      {"pole", "critical"},       {"sign", "critical"}, {"moving-car", "moving"}};
  int id = 0;
  for (const auto& [name, role] : classes) {
    auto* const entry = declaration.add_classes();
    entry->set_id(id++);
    entry->set_name(name);
    for (int i = 0; i < 3; ++i) entry->add_color(100);
    if (*role != '\0') entry->add_roles(role);
  }
  return sensor::LabelSet::Create(declaration).value();
}
inline constexpr int kNumSmallLabels = 9;

inline void AddGroup(const std::string& name, const std::vector<std::string>& roles, double weight,
                     int saturation_hits, bool apart, proto::ScoreOptions* options) {
  auto* const group = options->add_groups();
  group->set_name(name);
  for (const std::string& role : roles) group->add_roles(role);
  group->set_weight(weight);
  group->set_saturation_hits(saturation_hits);
  group->set_apart(apart);
}

// Weights by label: unlabeled and ground 1/4, car 1/2, building and vegetation 1, critical 3,
// moving none; one saturation for all.
inline proto::ScoreOptions SmallOptions(const std::string& score, double partial_agreement = 0.,
                                        int saturation_hits = 4) {
  proto::ScoreOptions options;
  options.set_score(score);
  options.set_partial_agreement(partial_agreement);
  options.set_max_range_m(100.);
  AddGroup("moving", {"moving"}, 0., saturation_hits, false, &options);
  AddGroup("critical", {"critical"}, 3., saturation_hits, false, &options);
  AddGroup("movable", {"movable"}, 0.5, saturation_hits, false, &options);
  AddGroup("weak", {"ground", "unlabeled"}, 0.25, saturation_hits, false, &options);
  AddGroup("rest", {}, 1., saturation_hits, true, &options);
  return options;
}

inline ScoreModel SmallModel(const proto::ScoreOptions& options) {
  return ScoreModel::Create(options, SmallLabelSet()).value();
}

inline sensor::Label LabelAt(int index) { return sensor::Label{static_cast<uint8_t>(index)}; }

inline void AddPoint(double x, double y, int label, sensor::LabeledPointCloud* cloud) {
  cloud->positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.f);
  cloud->labels.push_back(LabelAt(label));
  cloud->certainties.push_back(1.f);
}

// The score, written down once more from its definition and without haste: weights and agreement
// are worked out here from the options, cell by cell from the grid.
class PlainScore {
 public:
  PlainScore(const proto::ScoreOptions& options, const submap::SemanticGrid& grid)
      : options_(options), saturation_(options.groups(0).saturation_hits()) {
    const auto box = grid.Bounds();
    for (int y = box.min.y(); y < box.max.y(); ++y) {
      for (int x = box.min.x(); x < box.max.x(); ++x) AddCell(grid, {x, y});
    }
  }

  // In steps of 1/255 of 1/64.
  static int Weight(const std::string& score, int label) {
    constexpr int kWeights[kNumSmallLabels] = {16, 32, 16, 16, 64, 64, 192, 192, 0};
    constexpr int kOccupancyWeights[kNumSmallLabels] = {64, 64, 0, 0, 64, 64, 64, 64, 0};
    return score == "occupancy" ? kOccupancyWeights[label] : kWeights[label];
  }

  // A label's agreement with a cell, in steps of 1/255.
  int Agreement(int label, int x, int y) const {
    const auto it = agreement_.find({x, y});
    return it == agreement_.end() ? 0 : it->second[label];
  }

 private:
  void AddCell(const submap::SemanticGrid& grid, const submap::CellIndex& cell) {
    std::vector<int> hits;
    for (int label = 0; label < kNumSmallLabels; ++label) {
      hits.push_back(grid.Hits(LabelAt(label), cell));
    }
    if (*std::max_element(hits.begin(), hits.end()) == 0) return;
    const auto first_labeled = hits.begin() + 1;
    const auto most = std::max_element(first_labeled, hits.end());
    const int dominant = *most > 0 ? static_cast<int>(most - hits.begin()) : 0;
    bool occupied = false;
    for (const int label : {0, 1, 4, 5, 6, 7}) occupied |= hits[label] > 0;
    std::vector<int>& agreement = agreement_[{cell.x(), cell.y()}];
    for (int label = 0; label < kNumSmallLabels; ++label) {
      const double share = std::min(1., static_cast<double>(hits[label]) / saturation_);
      double v = share;
      if (options_.score() == "occupancy") v = occupied ? 1. : 0.;
      if (options_.score() == "dominant_label" && label != dominant) {
        v = options_.partial_agreement() * share;
      }
      agreement.push_back(static_cast<int>(std::lround(255. * v)));
    }
  }

  const proto::ScoreOptions options_;
  const int saturation_;
  std::map<std::pair<int, int>, std::vector<int>> agreement_;
};

// A grid and a scan without any structure, so that many poses score alike.
struct RandomScene {
  RandomScene(int side_cells, int num_hits, int num_points, double radius_m, std::mt19937* random)
      : grid(0.5) {
    std::uniform_int_distribution<int> cell(-side_cells / 2, side_cells / 2);
    std::uniform_int_distribution<int> label(0, kNumSmallLabels - 1), hits(1, 6);
    std::uniform_real_distribution<double> coordinate(-radius_m * M_SQRT1_2, radius_m * M_SQRT1_2);
    for (int i = 0; i < num_hits; ++i) {
      const int x = cell(*random), y = cell(*random), l = label(*random);
      grid.AddHits(LabelAt(l), {x, y}, hits(*random));
    }
    for (int i = 0; i < num_points; ++i) {
      const double x = coordinate(*random), y = coordinate(*random);
      AddPoint(x, y, label(*random), &cloud);
    }
  }

  submap::SemanticGrid grid;
  sensor::LabeledPointCloud cloud;
};

}  // namespace cartographer::scan_matching

#endif  // TEST_CARTOGRAPHER_SCAN_MATCHING_SMALL_SCENES_H_
