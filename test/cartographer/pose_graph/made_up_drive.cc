// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/cartographer/pose_graph/made_up_drive.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "glog/logging.h"
#include "test/testing/shipped_options.h"

namespace cartographer::pose_graph {
namespace {

using submap::Constraint;
using submap::NodeId;
using submap::SubmapId;
using transform::Rigid3d;

constexpr int kSubmapNodes = 10;

Eigen::Vector3d OnTrack(double lap) {
  const double angle = 2. * M_PI * lap;
  return {60. * std::cos(angle), 30. * std::sin(angle) + 18. * std::sin(2. * angle),
          4. * std::sin(angle + 1.)};
}

Rigid3d PoseOnTrack(double lap) {
  const Eigen::Vector3d ahead = OnTrack(lap + 1e-4) - OnTrack(lap - 1e-4);
  const double heading = std::atan2(ahead.y(), ahead.x());
  const double pitch = -std::atan2(ahead.z(), ahead.head<2>().norm());
  const double roll = 0.03 * std::sin(6. * M_PI * lap);
  return Rigid3d(OnTrack(lap), Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) *
                                   Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                   Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
}

void AppendBytes(const Rigid3d& pose, std::string* bytes) {
  const auto append = [bytes](const double* values, size_t size) {
    bytes->append(reinterpret_cast<const char*>(values), size * sizeof(double));
  };
  append(pose.translation().data(), 3);
  append(pose.rotation().coeffs().data(), 4);
}

}  // namespace

proto::OptimizationOptions OptimizationDefaults(const std::string& changes) {
  return semantic_kiss_testing::ShippedOptions<proto::OptimizationOptions>("optimization",
                                                                           "OPTIMIZATION", changes);
}

Poses Laps(double num_laps) {
  Poses poses;
  for (int i = 0; i < num_laps * kNodesPerLap; ++i) {
    poses.push_back(PoseOnTrack(static_cast<double>(i % kNodesPerLap) / kNodesPerLap));
  }
  return poses;
}

Poses WithErrors(const Poses& truth, const OdometryErrors& errors) {
  std::mt19937 random(errors.seed);
  std::normal_distribution<double> normal;
  Poses odometry = {truth.front()};
  for (size_t i = 1; i < truth.size(); ++i) {
    const Rigid3d step = truth[i - 1].inverse() * truth[i];
    const double length_m = step.translation().norm();
    transform::Twist noise;
    for (int k = 0; k < 6; ++k) {
      noise[k] = errors.sigmas_per_sqrt_m[k] * std::sqrt(length_m) * normal(random);
    }
    odometry.push_back(odometry.back() * step * transform::Exp(length_m * errors.twist_per_m) *
                       transform::Exp(noise));
  }
  return odometry;
}

void AddTrajectory(int trajectory_id, const Poses& odometry, Graph* graph) {
  const int size = static_cast<int>(odometry.size());
  for (int i = 0; i < size; ++i) {
    graph->nodes[NodeId{trajectory_id, i}] = {common::Time(), odometry[i], odometry[i], nullptr};
  }
  for (int begin = 0; begin < size; begin += kSubmapNodes / 2) {
    const SubmapId id{trajectory_id, begin / (kSubmapNodes / 2)};
    const Rigid3d local_from_submap = transform::Level(odometry[begin]);
    graph->submaps[id] = {local_from_submap, nullptr};
    for (int i = begin; i < std::min(size, begin + kSubmapNodes); ++i) {
      Constraint constraint;
      constraint.submap_id = id;
      constraint.node_id = {trajectory_id, i};
      constraint.submap_from_node = local_from_submap.inverse() * odometry[i];
      graph->constraints.push_back(constraint);
    }
  }
}

Constraint TrueLoop(const Graph& graph, const SubmapId& submap_id, const Poses& truth_of_submap,
                    const NodeId& node_id, const Poses& truth_of_node) {
  const int begin = submap_id.submap_index * (kSubmapNodes / 2);
  const int end = std::min<int>(static_cast<int>(truth_of_submap.size()), begin + kSubmapNodes);
  const int middle = begin + (end - begin) / 2;
  const auto in_submap = [&](const Constraint& constraint) {
    return constraint.submap_id == submap_id &&
           constraint.node_id == NodeId{submap_id.trajectory_id, middle};
  };
  const auto tie = std::find_if(graph.constraints.begin(), graph.constraints.end(), in_submap);
  CHECK(tie != graph.constraints.end());
  Constraint loop = *tie;
  loop.submap_from_node =
      loop.submap_from_node * truth_of_submap[middle].inverse() * truth_of_node[node_id.node_index];
  loop.node_id = node_id;
  loop.kind = Constraint::Kind::kInterSubmap;
  loop.translation_weight = 1. / 0.05;
  loop.rotation_weight = 1. / (0.1 * M_PI / 180.);
  return loop;
}

void AddTrueLoops(int trajectory_id, const Poses& truth, double min_laps, Graph* graph) {
  const int nodes_since = static_cast<int>(min_laps * kNodesPerLap);
  for (int i = nodes_since; i < static_cast<int>(truth.size()); i += 4) {
    const int submap_index =
        std::max(0, (i % kNodesPerLap - kSubmapNodes / 2) / (kSubmapNodes / 2));
    graph->constraints.push_back(TrueLoop(*graph, SubmapId{trajectory_id, submap_index}, truth,
                                          NodeId{trajectory_id, i}, truth));
  }
}

OdometryErrors RandomErrors() {
  OdometryErrors errors;
  errors.sigmas_per_sqrt_m << 0.02, 0.02, 0.02, 5e-4, 5e-4, 5e-4;
  return errors;
}

Graph DriftedGraph(const Poses& truth, const OdometryErrors& errors, double min_laps) {
  Graph graph;
  AddTrajectory(0, WithErrors(truth, errors), &graph);
  AddTrueLoops(0, truth, min_laps, &graph);
  return graph;
}

double LargestError_m(const Graph& graph, int trajectory_id, const Poses& should_be) {
  double largest = 0.;
  for (size_t i = 0; i < should_be.size(); ++i) {
    const Rigid3d& pose = graph.nodes.at(NodeId{trajectory_id, static_cast<int>(i)}).map_from_node;
    largest = std::max(largest, (pose.translation() - should_be[i].translation()).norm());
  }
  return largest;
}

std::string Bytes(const Graph& graph) {
  std::string bytes;
  for (const auto& [id, node] : graph.nodes) AppendBytes(node.map_from_node, &bytes);
  for (const auto& [id, submap] : graph.submaps) AppendBytes(submap.map_from_submap, &bytes);
  return bytes;
}

}  // namespace cartographer::pose_graph
