// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/submap/probability_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "glog/logging.h"

namespace cartographer::submap {
namespace {

constexpr double kLogOddsUnit = 1e-3;

// From `origin` to the centres of `cells`, in cells; of those in the same direction the farthest.
// Directions are told apart as far as they are a cell apart at the farthest cell of all.
std::vector<Eigen::Vector2d> FarthestByDirection(const Eigen::Vector2d& origin,
                                                 const std::vector<CellIndex>& cells) {
  std::vector<Eigen::Vector2d> arms;
  arms.reserve(cells.size());
  double farthest = 1.;
  for (const CellIndex& cell : cells) {
    arms.emplace_back((cell.cast<double>() + 0.5).matrix() - origin);
    farthest = std::max(farthest, arms.back().norm());
  }
  const int num_directions = static_cast<int>(std::ceil(2. * M_PI * farthest));
  std::vector<Eigen::Vector2d> farthest_arms(num_directions, Eigen::Vector2d::Zero());
  for (const Eigen::Vector2d& arm : arms) {
    const double turn = std::atan2(arm.y(), arm.x()) / (2. * M_PI) + 0.5;
    const int direction = std::min(static_cast<int>(turn * num_directions), num_directions - 1);
    Eigen::Vector2d& so_far = farthest_arms[direction];
    if (arm.squaredNorm() > so_far.squaredNorm()) so_far = arm;
  }
  return farthest_arms;
}

}  // namespace

ProbabilityGrid::ProbabilityGrid(const proto::ProbabilityGridOptions& options)
    : resolution_m_(options.resolution_m()),
      hit_(ToLogOdds(options.hit_probability())),
      miss_(ToLogOdds(options.miss_probability())),
      cast_rays_(options.cast_rays()) {
  CHECK_GT(resolution_m_, 0.);
  CHECK_GT(hit_, 0);
  CHECK_LE(miss_, 0);
  probabilities_.reserve(2 * kMaxLogOdds + 1);
  for (int log_odds = -kMaxLogOdds; log_odds <= kMaxLogOdds; ++log_odds) {
    probabilities_.push_back(static_cast<float>(1. / (1. + std::exp(-log_odds * kLogOddsUnit))));
  }
}

ProbabilityGrid::LogOdds ProbabilityGrid::ToLogOdds(double probability) {
  return static_cast<LogOdds>(
      std::lround(std::log(probability / (1. - probability)) / kLogOddsUnit));
}

void ProbabilityGrid::InsertScan(const Eigen::Vector2d& origin,
                                 const std::vector<Eigen::Vector2d>& points) {
  if (points.empty()) return;
  const CellIndex origin_cell = CellOf(origin);
  SemanticGrid::CellBox box{origin_cell, origin_cell + 1};
  for (const Eigen::Vector2d& point : points) {
    const CellIndex cell = CellOf(point);
    box.min = box.min.min(cell);
    box.max = box.max.max(cell + 1);
  }
  Grow(box);
  BeginScan();
  std::vector<CellIndex> hits;
  for (const Eigen::Vector2d& point : points) {
    const CellIndex cell = CellOf(point);
    if (Update(hit_, &cells_[OffsetOf(cell)])) hits.push_back(cell);
  }
  if (!cast_rays_) return;
  const Eigen::Vector2d from = origin / resolution_m_;
  for (const Eigen::Vector2d& arm : FarthestByDirection(from, hits)) CastRay(from, from + arm);
}

int ProbabilityGrid::EquivalentHits(const CellIndex& cell) const {
  const LogOdds log_odds = LogOddsOf(cell);
  if (log_odds <= 0) return 0;
  return std::max(1, static_cast<int>(std::lround(static_cast<double>(log_odds) / hit_)));
}

void ProbabilityGrid::Grow(const SemanticGrid::CellBox& box) {
  if (!box_.Empty() && (box.min >= box_.min).all() && (box.max <= box_.max).all()) return;
  const SemanticGrid::CellBox old_box = std::exchange(box_, box);
  if (!old_box.Empty()) {
    // The next scans will reach a little farther in the same direction.
    const CellIndex margin = (old_box.max - old_box.min) / 8;
    box_.min = old_box.min.min(box.min - (box.min < old_box.min).cast<int>() * margin);
    box_.max = old_box.max.max(box.max + (box.max > old_box.max).cast<int>() * margin);
  }
  const CellIndex size = box_.max - box_.min;
  const std::vector<Cell> old_cells =
      std::exchange(cells_, std::vector<Cell>(size_t(size.x()) * size.y()));
  const size_t old_width = old_box.max.x() - old_box.min.x();
  auto old_row = old_cells.begin();
  for (CellIndex row = old_box.min; row.y() < old_box.max.y(); ++row.y(), old_row += old_width) {
    std::copy_n(old_row, old_width, cells_.begin() + OffsetOf(row));
  }
}

void ProbabilityGrid::BeginScan() {
  if (scan_ == std::numeric_limits<uint16_t>::max()) {
    for (Cell& cell : cells_) cell.last_scan = 0;
    scan_ = 0;
  }
  ++scan_;
}

bool ProbabilityGrid::Update(LogOdds change, Cell* cell) const {
  if (cell->last_scan == scan_) return false;
  cell->last_scan = scan_;
  const int before = cell->log_odds == kUnknown ? 0 : cell->log_odds;
  cell->log_odds =
      static_cast<LogOdds>(std::clamp<int>(before + change, -int{kMaxLogOdds}, int{kMaxLogOdds}));
  return true;
}

// Walks from border to border of cells. Source: Amanatides and Woo, "A Fast Voxel Traversal
// Algorithm for Ray Tracing", 1987.
void ProbabilityGrid::CastRay(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const CellIndex last = to.array().floor().cast<int>();
  CellIndex cell = from.array().floor().cast<int>();
  const Eigen::Vector2d direction = to - from;
  const ptrdiff_t row = box_.max.x() - box_.min.x();
  ptrdiff_t strides[2] = {1, row};
  double next[2], step[2];  // where the ray crosses the next border of each axis: shares of its way
  for (int axis = 0; axis < 2; ++axis) {
    const bool up = direction[axis] > 0.;
    if (!up) strides[axis] = -strides[axis];
    step[axis] = 1. / std::abs(direction[axis]);
    const double to_border =
        up ? cell[axis] + 1 - from[axis] : from[axis] - static_cast<double>(cell[axis]);
    next[axis] = to_border * step[axis];
  }
  const CellIndex distance = (last - cell).abs();
  int left = distance.x() + distance.y();
  int left_of_axis[2] = {distance.x(), distance.y()};
  Cell* at = &cells_[OffsetOf(cell)];
  while (left-- > 0) {
    Update(miss_, at);
    // Round-off must not lead past the last cell's row or column.
    const int axis = left_of_axis[1] == 0 || (left_of_axis[0] > 0 && next[0] < next[1]) ? 0 : 1;
    --left_of_axis[axis];
    next[axis] += step[axis];
    at += strides[axis];
  }
}

}  // namespace cartographer::submap
