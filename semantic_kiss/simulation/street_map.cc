// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/simulation/street_map.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "semantic_kiss/simulation/random.h"
#include "semantic_kiss/simulation/synthetic_routes.h"

namespace semantic_kiss::simulation {
namespace {

constexpr double kNode_m = 0.5;
// On a motorway the centre line is the central reservation.
constexpr double kHighwayLaneOffset_m = 8.6;
constexpr double kHighwayHalfWidth_m = 12.5;
// The centre line swings from town to motorway over this distance.
constexpr double kTransition_m = 120.;
// A visit this near to a known centre line drives on the same street.
constexpr double kSameStreet_m = 3.;
constexpr double kSameStreetHighway_m = 12.;
// From point to point.
constexpr double kBend_rad = 0.03;

double DistanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                         const Eigen::Vector2d& to) {
  const Eigen::Vector2d span = to - from;
  const double length2 = span.squaredNorm();
  const double t = length2 > 0. ? std::clamp((point - from).dot(span) / length2, 0., 1.) : 0.;
  return (point - from - t * span).norm();
}

// Sections vary slowly in the plane, so that all visits find the same street.
StreetSection SectionAt(const Eigen::Vector2d& p, bool highway, uint64_t seed) {
  StreetSection section;
  section.highway = highway;
  if (highway) {
    section.half_width_m = kHighwayHalfWidth_m;
    section.sidewalk_m = 0.;
    section.kerb_m = 0.;
    return section;
  }
  const uint64_t key = HashKey({seed, static_cast<uint64_t>(Purpose::kStreet)});
  const auto noise = [&](uint64_t n, double length_m) {
    return SmoothNoise(key + n, p.x() / length_m, p.y() / length_m);
  };
  section.half_width_m = 3.5 + 0.7 * noise(1, 150.);
  section.sidewalk_m = 3.2 + 2. * noise(2, 100.);
  for (int side : {0, 1}) {
    if (noise(3 + side, 70.) > 0.2) section.parking_m[side] = 2.2;
  }
  return section;
}

Eigen::AlignedBox2d BoundsOf(const Route& route, double margin_m) {
  Eigen::AlignedBox2d bounds;
  for (const PlanarPose& pose : route.poses) bounds.extend(pose.position);
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(margin_m + StreetMap::kReach_m + 20.);
  return Eigen::AlignedBox2d(bounds.min() - margin, bounds.max() + margin);
}

// Distance of the street's middle to the left of the car, easing between town and motorway.
std::vector<double> LaneOffsets(const std::vector<StreetPoint>& points) {
  std::vector<double> offsets(points.size());
  const int half = static_cast<int>(0.5 * kTransition_m);
  const int size = static_cast<int>(points.size());
  int count = 0, highway = 0, first = 0, last = 0;
  for (int i = 0; i < size; ++i) {
    for (; last < std::min(size, i + half); ++last, ++count) highway += points[last].highway;
    for (; first < i - half; ++first, --count) highway -= points[first].highway;
    const double share = static_cast<double>(highway) / count;
    offsets[i] = kLaneOffset_m + share * (kHighwayLaneOffset_m - kLaneOffset_m);
  }
  return offsets;
}

// The driven line with points about a metre apart.
std::vector<StreetPoint> DrivenLine(const Route& route) {
  std::vector<StreetPoint> line;
  for (size_t i = 0; i < route.poses.size(); ++i) {
    if (line.empty()) {
      line.push_back({route.poses[i], route.on_highway[i]});
      continue;
    }
    const PlanarPose from = line.back().pose;
    const double gap_m = (route.poses[i].position - from.position).norm();
    if (gap_m < 0.8) continue;
    const int pieces = static_cast<int>(std::ceil(gap_m / 1.2));
    for (int k = 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      line.push_back({{from.position + t * (route.poses[i].position - from.position),
                       from.yaw + t * (route.poses[i].yaw - from.yaw)},
                      route.on_highway[i]});
    }
  }
  return line;
}

}  // namespace

StreetMap::StreetMap(const Route& route, double margin_m, uint64_t seed)
    : bounds_(BoundsOf(route, margin_m)), nodes_(bounds_, kNode_m, Node()) {
  for (size_t i = 1; i < route.poses.size(); ++i) {
    StampDriven(route.poses[i - 1].position, route.poses[i].position);
  }
  const Eigen::Vector2d rim = Eigen::Vector2d::Constant(kReach_m + 10.);
  const Eigen::AlignedBox2d wanted(bounds_.min() + rim, bounds_.max() - rim);
  for (const std::vector<StreetPoint>& street : route.side_streets) {
    std::vector<StreetPoint> kept;
    for (const StreetPoint& point : street) {
      if (wanted.contains(point.pose.position)) kept.push_back(point);
    }
    AddSideStreet(kept, seed);
  }
  AddDrivenStreets(route, seed);
}

void StreetMap::Append(const StreetPoint& point, int order, bool goes_on, uint64_t seed) {
  CentrePoint centre;
  centre.pose = point.pose;
  centre.order = order;
  centre.section = SectionAt(point.pose.position, point.highway, seed);
  if (goes_on) {
    const CentrePoint& last = centres_.back();
    centre.arc_m = last.arc_m + (point.pose.position - last.pose.position).norm();
    centre.bend = std::abs(point.pose.yaw - last.pose.yaw) > kBend_rad;
  } else {
    streets_.emplace_back(centres_.size(), centres_.size());
  }
  centres_.push_back(centre);
  streets_.back().second = centres_.size();
}

void StreetMap::AddSideStreet(const std::vector<StreetPoint>& points, uint64_t seed) {
  for (size_t i = 0; i < points.size(); ++i) {
    Append(points[i], -1, i > 0, seed);
    if (i > 0) StampSection(centres_.size() - 2);
  }
}

void StreetMap::AddDrivenStreets(const Route& route, uint64_t seed) {
  const std::vector<StreetPoint> line = DrivenLine(route);
  const std::vector<double> offsets = LaneOffsets(line);
  // Stamped late, so that the line does not take its own recent past for a street that it knows.
  constexpr int kDelay = 40;
  std::deque<size_t> unstamped;
  bool goes_on = false;
  for (int i = 0; i < static_cast<int>(line.size()); ++i) {
    StreetPoint point = line[i];
    point.pose.position += offsets[i] * line[i].pose.Left();
    const bool known = IsKnownStreet(point);
    if (!known) {
      if (goes_on) unstamped.push_back(centres_.size() - 1);
      Append(point, i, goes_on, seed);
    }
    goes_on = !known;
    while (!unstamped.empty() && centres_[unstamped.front()].order + kDelay < i) {
      StampSection(unstamped.front());
      unstamped.pop_front();
    }
  }
  for (const size_t index : unstamped) StampSection(index);
}

bool StreetMap::IsKnownStreet(const StreetPoint& point) const {
  const Place place = Find(point.pose.position);
  if (place.nearest < 0) return false;
  return place.across_m < (point.highway ? kSameStreetHighway_m : kSameStreet_m) &&
         std::abs(std::sin(centres_[place.nearest].pose.yaw - point.pose.yaw)) < 0.5;
}

void StreetMap::StampSection(size_t index) {
  const Eigen::Vector2d from = centres_[index].pose.position;
  const Eigen::Vector2d to = centres_[index + 1].pose.position;
  const double half_width_m = centres_[index].section.half_width_m;
  const double reach_m = kReach_m + half_width_m;
  for (int j = nodes_.Node(from.y() - reach_m); j <= nodes_.Node(from.y() + reach_m) + 1; ++j) {
    for (int i = nodes_.Node(from.x() - reach_m); i <= nodes_.Node(from.x() + reach_m) + 1; ++i) {
      const Eigen::Vector2d point = kNode_m * Eigen::Vector2d(i, j);
      if (!bounds_.contains(point)) continue;
      const double outside_m = DistanceToSegment(point, from, to) - half_width_m;
      Node& node = nodes_.MutableAt(i, j);
      if (outside_m >= node.outside_m) continue;
      node.outside_m = static_cast<float>(outside_m);
      node.nearest = static_cast<int32_t>(index);
    }
  }
}

void StreetMap::StampDriven(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  // Far less than the reach: nothing cares about the driven line at a greater distance.
  constexpr double kDrivenReach_m = 8.;
  const Eigen::Vector2d low = from.cwiseMin(to).array() - kDrivenReach_m;
  const Eigen::Vector2d high = from.cwiseMax(to).array() + kDrivenReach_m;
  for (int j = nodes_.Node(low.y()); j <= nodes_.Node(high.y()) + 1; ++j) {
    for (int i = nodes_.Node(low.x()); i <= nodes_.Node(high.x()) + 1; ++i) {
      const double distance_m = DistanceToSegment(kNode_m * Eigen::Vector2d(i, j), from, to);
      if (distance_m > kDrivenReach_m) continue;
      Node& node = nodes_.MutableAt(i, j);
      node.clearance_m = std::min(node.clearance_m, static_cast<float>(distance_m));
    }
  }
}

StreetMap::Place StreetMap::Find(const Eigen::Vector2d& position) const {
  const auto patch = nodes_.PatchAt(position.x(), position.y());
  const Node& node = *patch.corners[(patch.u > 0.5 ? 1 : 0) + (patch.v > 0.5 ? 2 : 0)];
  Place place{Bilinear(patch, patch.corners[0]->outside_m, patch.corners[1]->outside_m,
                       patch.corners[2]->outside_m, patch.corners[3]->outside_m),
              node.nearest, 0, kReach_m, node.cover};
  if (node.nearest < 0) return place;
  const CentrePoint& centre = centres_[node.nearest];
  const Eigen::Vector2d offset = position - centre.pose.position;
  place.side = centre.pose.Left().dot(offset) >= 0. ? 0 : 1;
  place.across_m =
      DistanceToSegment(position, centre.pose.position, centres_[node.nearest + 1].pose.position);
  return place;
}

double StreetMap::Outside(const Eigen::Vector2d& position) const {
  const auto patch = nodes_.PatchAt(position.x(), position.y());
  return Bilinear(patch, patch.corners[0]->outside_m, patch.corners[1]->outside_m,
                  patch.corners[2]->outside_m, patch.corners[3]->outside_m);
}

double StreetMap::Clearance(const Eigen::Vector2d& position) const {
  const auto patch = nodes_.PatchAt(position.x(), position.y());
  return Bilinear(patch, patch.corners[0]->clearance_m, patch.corners[1]->clearance_m,
                  patch.corners[2]->clearance_m, patch.corners[3]->clearance_m);
}

void StreetMap::SetCover(const Eigen::Vector2d& position, Cover cover) {
  if (!bounds_.contains(position)) return;
  nodes_
      .MutableAt(nodes_.Node(position.x() + 0.5 * kNode_m),
                 nodes_.Node(position.y() + 0.5 * kNode_m))
      .cover = cover;
}

}  // namespace semantic_kiss::simulation
