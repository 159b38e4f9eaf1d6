// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/testing/small_map.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "glog/logging.h"

namespace semantic_kiss_testing {

namespace map = cartographer::map;
namespace sensor = cartographer::sensor;
namespace submap = cartographer::submap;
namespace transform = cartographer::transform;

namespace {

sensor::LabeledPointCloud RandomCloud(int size, float max_range_m, bool optional_columns,
                                      std::mt19937* random) {
  std::uniform_real_distribution<float> uniform(0.f, 1.f);
  sensor::LabeledPointCloud cloud;
  for (int i = 0; i < size; ++i) {
    const float range = max_range_m * uniform(*random), angle = 6.28f * uniform(*random);
    cloud.positions.emplace_back(range * std::cos(angle), range * std::sin(angle),
                                 3.f * uniform(*random) - 1.7f);
    cloud.labels.push_back(sensor::Label{static_cast<uint8_t>((*random)() % 5)});
    cloud.certainties.push_back(uniform(*random));
    if (!optional_columns) continue;
    cloud.intensities.push_back(uniform(*random));
    cloud.times.push_back(-0.1f * uniform(*random));
  }
  return cloud;
}

}  // namespace

sensor::LabelSet StreetLabels() {
  sensor::proto::LabelSet declaration;
  declaration.set_name("street");
  declaration.set_default_certainty(0.75);
  const auto add = [&declaration](int id, const std::string& name, const std::string& role) {
    sensor::proto::LabelClass& label_class = *declaration.add_classes();
    label_class.set_id(id);
    label_class.set_name(name);
    for (const int component : {id, 2 * id, 255 - id}) label_class.add_color(component);
    if (!role.empty()) label_class.add_roles(role);
  };
  add(0, "unlabeled", "unlabeled");
  add(40, "road", "ground");
  add(10, "car", "movable");
  add(50, "building", "");
  add(80, "pole", "critical");
  absl::StatusOr<sensor::LabelSet> labels = sensor::LabelSet::Create(declaration);
  CHECK(labels.ok()) << labels.status();
  return *std::move(labels);
}

transform::Rigid3d RandomPose(std::mt19937* random) {
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const Eigen::Vector3d position(100. * uniform(*random), 100. * uniform(*random),
                                 uniform(*random));
  const Eigen::AngleAxisd heading(3. * uniform(*random), Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd pitch(0.05 * uniform(*random), Eigen::Vector3d::UnitY());
  return transform::Rigid3d(position, heading * pitch);
}

map::Map SmallMap(int nodes_per_trajectory, int points_per_node, float max_range_m) {
  std::mt19937 random(7);
  map::Map map;
  map.labels = StreetLabels();
  map.configuration_lua = "return { voxel_size_m = 1. }\n";
  map.history = {"semantic_kiss 0.1.0", "filter --remove=car"};
  for (const int trajectory : {1, 4}) {
    for (int i = 0; i < nodes_per_trajectory; ++i) {
      const submap::NodeId node_id{trajectory, 3 + i};
      map::MapNode& node = map.nodes[node_id];
      node.time = cartographer::common::FromUnixSeconds(1e9 + 100. * trajectory + 0.1 * i);
      node.map_from_node = RandomPose(&random);
      node.local_from_node = RandomPose(&random);
      node.cloud = std::make_shared<sensor::LabeledPointCloud>(
          RandomCloud(points_per_node, max_range_m, trajectory == 4, &random));

      const submap::SubmapId submap_id{trajectory, i / 2};
      map.constraints.push_back({submap_id, node_id, RandomPose(&random), 1e3, 2.5e2,
                                 map::Constraint::Kind::kIntraSubmap});
      if (i % 2 == 1) continue;
      auto submap = std::make_shared<submap::Submap>(0.25);
      submap->local_from_submap = transform::Level(RandomPose(&random));
      submap->num_scans = 2;
      submap->finished = i + 2 < nodes_per_trajectory;
      submap->cloud = RandomCloud(2 * points_per_node, max_range_m, false, &random);
      for (size_t j = 0; j < submap->cloud.size(); ++j) {
        const Eigen::Vector2f position = submap->cloud.positions[j].head<2>();
        submap->grid.AddHits(submap->cloud.labels[j], submap->grid.CellOf(position),
                             1 + static_cast<int>(random() % (j == 0 ? 100000 : 20)));
      }
      map.submaps[submap_id] = {transform::Level(RandomPose(&random)), std::move(submap)};
    }
  }
  if (nodes_per_trajectory > 0) {
    map.constraints.push_back(
        {{4, 0}, {1, 3}, RandomPose(&random), 10., 20., map::Constraint::Kind::kInterSubmap});
  }
  return map;
}

}  // namespace semantic_kiss_testing
