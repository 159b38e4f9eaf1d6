// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/cartographer/slam/street_localization.h"

#include <cmath>
#include <memory>
#include <utility>

#include "cartographer/slam/graph_of_map.h"
#include "glog/logging.h"
#include "test/cartographer/pose_graph/street_drive.h"
#include "test/testing/shipped_options.h"

namespace cartographer::slam {
namespace {

using transform::Rigid3d;

// As configuration_files/relocalize.lua has it; the map has few places to choose from.
constexpr char kSearching[] = R"lua(
  POSE_GRAPH.optimize_every_n_nodes = 1
  POSE_GRAPH.candidates.node_spacing_m = 3
  POSE_GRAPH.candidates.max_places = 2
)lua";

// Poses as the visit has them, in a local frame that begins with the first scan that comes.
class OdometryOfVisit : public LocalTrajectoryBuilder {
 public:
  explicit OdometryOfVisit(const std::vector<Rigid3d>& odometry)
      : odometry_(odometry), submaps_(pose_graph::SmallSubmaps(), scan_matching::SmallLabelSet()) {}

  LocalResult AddScan(const sensor::LabeledScan& scan) override {
    if (!first_.has_value()) first_ = scan.index;
    LocalResult result;
    result.time = scan.time;
    result.local_from_sensor = odometry_[*first_].inverse() * odometry_[scan.index];
    result.outcome = "scripted";
    if ((scan.index - *first_) % 2 == 0) {
      result.insertion.emplace();
      result.insertion->cloud = std::make_shared<const sensor::LabeledPointCloud>(scan.points);
      result.insertion->submaps =
          submaps_.AddScan(scan.points, scan.points, result.local_from_sensor);
    }
    return result;
  }
  void Finish() override { submaps_.FinishAll(); }

 private:
  const std::vector<Rigid3d>& odometry_;
  std::optional<int> first_;
  submap::ActiveSubmaps submaps_;
};

std::unique_ptr<pose_graph::PoseGraph> CreatePoseGraph(const std::string& changes) {
  auto graph = pose_graph::PoseGraph::Create(
      semantic_kiss_testing::ShippedOptions<pose_graph::proto::PoseGraphOptions>(
          "pose_graph", "POSE_GRAPH", changes),
      scan_matching::SmallLabelSet());
  CHECK(graph.ok()) << graph.status();
  return *std::move(graph);
}

sensor::LabeledScan ScanOf(const StreetVisit& visit,
                           const std::vector<pose_graph::ScenePoint>& street, int index) {
  sensor::LabeledScan scan;
  scan.index = index;
  scan.time = common::FromUnixSeconds(1000. + 0.1 * index);
  if (!visit.blind(index)) {
    scan.points = pose_graph::SeeFrom(street, visit.truth[index], {1000 + index, /*share=*/0.05});
  }
  return scan;
}

}  // namespace

void DriveOn(double x, double y, bool forwards, int meters, StreetVisit* visit) {
  const Rigid3d step = Rigid3d::Translation({0.5, 0., 0.});
  for (int i = 0; i < 2 * meters; ++i) {
    const double along = forwards ? x + 0.5 * i : x - 0.5 * i;
    const Rigid3d pose = pose_graph::NodeOnStreet(along, y, forwards ? 0. : M_PI);
    if (visit->odometry.empty()) {
      visit->odometry.push_back(Rigid3d::Translation({300., -200., 10.}));
    } else {
      const bool jumps = i == 0;
      visit->odometry.push_back(visit->odometry.back() *
                                (jumps ? step : visit->truth.back().inverse() * pose));
    }
    visit->truth.push_back(pose);
  }
}

int Localized::FirstWith(LocalizationState state, int from) const {
  for (size_t i = from; i < scans.size(); ++i) {
    if (scans[i].state == state) return static_cast<int>(i);
  }
  return -1;
}

const map::Map& MapOfStreet() {
  static const map::Map& map = *new map::Map([] {
    const auto graph = CreatePoseGraph("POSE_GRAPH.optimize_every_n_nodes = 0");
    std::vector<Rigid3d> poses;
    for (int x = -15; x <= 15; ++x) poses.push_back(pose_graph::NodeOnStreet(x, 0., 0.));
    pose_graph::DriveOnStreet({0, poses, poses}, graph.get());
    return MapOf(graph->Release(), scan_matching::SmallLabelSet());
  }());
  return map;
}

Localized Localize(const map::Map& map, const StreetVisit& visit, const std::string& changes,
                   const std::function<void(Relocalizer*)>& prepare) {
  pose_graph::StreetOptions street_options;
  street_options.seed = visit.street;
  street_options.parked_cars = visit.street;
  const std::vector<pose_graph::ScenePoint> street = pose_graph::MakeStreet(street_options);
  Localized localized;
  auto graph = CreatePoseGraph(kSearching);
  const pose_graph::PoseGraph& graph_inside = *graph;
  Relocalizer relocalizer(
      semantic_kiss_testing::ShippedOptions<proto::RelocalizationOptions>(
          "relocalization", "RELOCALIZATION", changes),
      [&] {
        ++localized.num_odometries;
        return std::make_unique<OdometryOfVisit>(visit.odometry);
      },
      std::move(graph), map);
  prepare(&relocalizer);
  for (int i = 0; i < static_cast<int>(visit.truth.size()); ++i) {
    localized.scans.push_back(relocalizer.AddScan(ScanOf(visit, street, i)));
  }
  localized.smoothed = relocalizer.Finish();
  localized.num_nodes = graph_inside.graph().nodes.size();
  return localized;
}

}  // namespace cartographer::slam
