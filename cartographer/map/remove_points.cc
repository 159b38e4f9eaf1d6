// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/map/remove_points.h"

#include <memory>
#include <utility>
#include <vector>

#include "cartographer/common/parallel.h"
#include "cartographer/sensor/labeled_point_cloud.h"

namespace cartographer::map {
namespace {

using sensor::LabeledPointCloud;
using submap::SemanticGrid;

constexpr size_t kNodesPerChunk = 16;

// The points for whose index goes() is false; nullptr if that are all.
template <typename Goes>
std::shared_ptr<LabeledPointCloud> Without(const LabeledPointCloud& cloud, const Goes& goes) {
  std::vector<size_t> kept;
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!goes(i)) kept.push_back(i);
  }
  if (kept.size() == cloud.size()) return nullptr;
  auto result = std::make_shared<LabeledPointCloud>();
  result->Reserve(kept.size());
  for (const size_t i : kept) result->Append(cloud, i);
  return result;
}

template <typename Goes>
void RemovePoints(const Goes& goes, MapSubmap* placed) {
  const auto cloud = Without(placed->submap->cloud, goes);
  if (cloud == nullptr) return;
  auto changed = std::make_shared<submap::Submap>(*placed->submap);
  changed->cloud = std::move(*cloud);
  placed->submap = std::move(changed);
}

template <typename Goes>
void RemovePoints(const Goes& goes, MapNode* node) {
  auto cloud = Without(*node->cloud, goes);
  if (cloud != nullptr) node->cloud = std::move(cloud);
}

// Those of the elements (submaps, nodes) for which `wanted` holds.
template <typename Element, typename Id, typename Wanted>
std::vector<std::pair<Id, Element*>> Select(std::map<Id, Element>* elements, const Wanted& wanted) {
  std::vector<std::pair<Id, Element*>> selected;
  for (auto& [id, element] : *elements) {
    if (wanted(id)) selected.emplace_back(id, &element);
  }
  return selected;
}

bool LiesIn(const Region& region, const transform::Rigid3d& map_from_cloud,
            const Eigen::Vector3f& position) {
  return region.IsEverywhere() ||
         region.Contains((map_from_cloud * position.cast<double>()).head<2>());
}

enum class Fate { kUnknown, kKept, kLost };

// What became of the hit of a point at `position`, in the grid's frame.
Fate FateOf(sensor::Label label, const Eigen::Vector2d& position, const SemanticGrid& kept,
            const SemanticGrid& lost) {
  // Files round positions to a millimetre, which takes a point near a border to the next cell.
  constexpr double kRounding_m = 1e-3;
  constexpr double kOffsets[][2] = {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  for (const auto& [x, y] : kOffsets) {
    const Eigen::Vector2d near = position + kRounding_m * Eigen::Vector2d(x, y);
    const submap::CellIndex cell = kept.CellOf(near.cast<float>());
    if (kept.Hits(label, cell) > 0) return Fate::kKept;
    if (lost.Hits(label, cell) > 0) return Fate::kLost;
  }
  return Fate::kUnknown;
}

// A submap that holds a node.
struct Holder {
  const SemanticGrid* kept;
  const SemanticGrid* lost;
  transform::Rigid3d grid_from_node;
};

// The submaps that hold a node, for the nodes that lie in one that lost something.
std::map<submap::NodeId, std::vector<Holder>> HoldersOf(const LostCells& lost, const Map& map) {
  static const SemanticGrid nothing(1.);
  std::map<submap::NodeId, std::vector<Holder>> holders;
  for (const bool losers : {true, false}) {
    for (const Constraint& constraint : map.constraints) {
      if (constraint.kind != Constraint::Kind::kIntraSubmap) continue;
      const auto found = lost.find(constraint.submap_id);
      if ((found != lost.end()) != losers) continue;
      if (!losers && holders.count(constraint.node_id) == 0) continue;
      const auto placed = map.submaps.find(constraint.submap_id);
      if (placed == map.submaps.end()) continue;
      holders[constraint.node_id].push_back({&placed->second.submap->grid,
                                             losers ? &found->second : &nothing,
                                             constraint.submap_from_node});
    }
  }
  return holders;
}

bool WasLost(sensor::Label label, const Eigen::Vector3d& position,
             const std::vector<Holder>& holders) {
  bool lost = false;
  for (const Holder& holder : holders) {
    const Eigen::Vector3d in_grid = holder.grid_from_node * position;
    const Fate fate = FateOf(label, in_grid.head<2>(), *holder.kept, *holder.lost);
    if (fate == Fate::kKept) return false;
    lost = lost || fate == Fate::kLost;
  }
  return lost;
}

}  // namespace

void RemoveLabeledPoints(const FilterScope& scope, const sensor::LabelMask& labels, Map* map) {
  const auto in_scope = [&scope](const auto& id) { return scope.Contains(id); };
  const auto submaps = Select(&map->submaps, in_scope);
  common::ParallelChunks(submaps.size(), 1, [&](size_t i, size_t) {
    MapSubmap& placed = *submaps[i].second;
    const LabeledPointCloud& cloud = placed.submap->cloud;
    RemovePoints(
        [&](size_t point) {
          return labels.Contains(cloud.labels[point]) &&
                 LiesIn(scope.region, placed.map_from_submap, cloud.positions[point]);
        },
        &placed);
  });
  const auto nodes = Select(&map->nodes, in_scope);
  common::ParallelChunks(nodes.size(), kNodesPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      MapNode& node = *nodes[i].second;
      const LabeledPointCloud& cloud = *node.cloud;
      RemovePoints(
          [&](size_t point) {
            return labels.Contains(cloud.labels[point]) &&
                   LiesIn(scope.region, node.map_from_node, cloud.positions[point]);
          },
          &node);
    }
  });
}

void RemovePointsOfLostCells(const LostCells& lost, Map* map) {
  const auto submaps =
      Select(&map->submaps, [&lost](const submap::SubmapId& id) { return lost.count(id) > 0; });
  common::ParallelChunks(submaps.size(), 1, [&](size_t i, size_t) {
    const auto& [id, placed] = submaps[i];
    const submap::Submap& submap = *placed->submap;
    RemovePoints(
        [&](size_t point) {
          const Eigen::Vector2d position = submap.cloud.positions[point].head<2>().cast<double>();
          return FateOf(submap.cloud.labels[point], position, submap.grid, lost.at(id)) ==
                 Fate::kLost;
        },
        placed);
  });
  const auto holders = HoldersOf(lost, *map);
  const auto nodes =
      Select(&map->nodes, [&holders](const submap::NodeId& id) { return holders.count(id) > 0; });
  common::ParallelChunks(nodes.size(), kNodesPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const std::vector<Holder>& holding = holders.at(nodes[i].first);
      const LabeledPointCloud& cloud = *nodes[i].second->cloud;
      RemovePoints(
          [&](size_t point) {
            return WasLost(cloud.labels[point], cloud.positions[point].cast<double>(), holding);
          },
          nodes[i].second);
    }
  });
}

}  // namespace cartographer::map
