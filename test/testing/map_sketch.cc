// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/testing/map_sketch.h"

#include <cctype>
#include <map>
#include <utility>

#include "glog/logging.h"

namespace semantic_kiss_testing {

namespace io = cartographer::io;
namespace map = cartographer::map;
namespace sensor = cartographer::sensor;
namespace submap = cartographer::submap;
namespace transform = cartographer::transform;

namespace {

struct SketchClass {
  char character;
  const char* name;
  const char* role;
  int red, green, blue;
};

constexpr SketchClass kClasses[] = {
    {'U', "unlabeled", "unlabeled", 0, 0, 0}, {'R', "road", "ground", 200, 100, 200},
    {'S', "sidewalk", "ground", 80, 40, 80},  {'B', "building", "", 240, 160, 20},
    {'C', "car", "movable", 60, 120, 240},    {'P', "traffic-sign", "critical", 220, 0, 0}};

sensor::Label LabelOf(char character) {
  for (const SketchClass& entry : kClasses) {
    if (entry.character == character) return SketchLabel(entry.name);
  }
  LOG(FATAL) << "no class is drawn as '" << character << "'";
  return sensor::kUnlabeled;
}

}  // namespace

sensor::LabelSet SketchLabels() {
  sensor::proto::LabelSet declaration;
  declaration.set_name("sketch");
  declaration.set_default_certainty(1.);
  for (const SketchClass& entry : kClasses) {
    sensor::proto::LabelClass* const added = declaration.add_classes();
    added->set_id(entry.character);
    added->set_name(entry.name);
    if (*entry.role != '\0') added->add_roles(entry.role);
    for (const int component : {entry.red, entry.green, entry.blue}) added->add_color(component);
  }
  auto labels = sensor::LabelSet::Create(declaration);
  CHECK(labels.ok()) << labels.status();
  return *std::move(labels);
}

sensor::Label SketchLabel(const std::string& name) {
  static const sensor::LabelSet* const labels = new sensor::LabelSet(SketchLabels());
  const auto label = labels->FromName(name);
  CHECK(label.ok()) << label.status();
  return *label;
}

std::shared_ptr<submap::Submap> SubmapFromSketch(const Sketch& sketch, double resolution_m,
                                                 int hits) {
  auto result = std::make_shared<submap::Submap>(resolution_m);
  for (int row = 0; row < sketch.size(); ++row) {
    for (int column = 0; column < sketch[row].size(); ++column) {
      if (sketch[row][column] == '.') continue;
      const int y = static_cast<int>(sketch.size()) - 1 - row;
      result->grid.AddHits(LabelOf(sketch[row][column]), {column, y}, hits);
    }
  }
  return result;
}

map::Map EmptyMap() {
  map::Map map;
  map.labels = SketchLabels();
  return map;
}

void AddSubmap(std::shared_ptr<const submap::Submap> submap, const transform::Rigid3d& pose,
               map::Map* map) {
  map->submaps[{0, static_cast<int>(map->submaps.size())}] = {pose, std::move(submap)};
}

void AddNode(const Eigen::Vector3d& position, map::Map* map) {
  map::MapNode node;
  node.map_from_node = transform::Rigid3d::Translation(position);
  node.cloud = std::make_shared<sensor::LabeledPointCloud>();
  map->nodes[{0, static_cast<int>(map->nodes.size())}] = node;
}

map::Map MapFromSketch(const Sketch& sketch, double resolution_m, int hits) {
  map::Map map = EmptyMap();
  AddSubmap(SubmapFromSketch(sketch, resolution_m, hits), transform::Rigid3d(), &map);
  return map;
}

transform::Rigid3d PlanarPose(double x, double y, double yaw_rad) {
  return {Eigen::Vector3d(x, y, 0.),
          Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()))};
}

io::SemanticRaster RasterFromSketch(const Sketch& sketch) {
  io::SemanticRaster raster;
  raster.frame = {1., 0., double(sketch.size()), static_cast<int>(sketch.front().size()),
                  static_cast<int>(sketch.size())};
  for (const std::string& row : sketch) {
    for (const char character : row) {
      raster.labels.push_back(character == '.' ? sensor::kUnlabeled : LabelOf(character));
      raster.hits.push_back(character == '.' ? 0.f : 1.f);
    }
  }
  return raster;
}

Sketch SketchOf(const io::SemanticRaster& raster) {
  std::map<sensor::Label, char> characters;
  for (const SketchClass& entry : kClasses) characters[SketchLabel(entry.name)] = entry.character;
  Sketch sketch(raster.frame.height);
  for (size_t i = 0; i < raster.labels.size(); ++i) {
    const char character = characters.at(raster.labels[i]);
    const bool seen = raster.hits[i] > 0.f;
    const bool nothing = !seen && raster.labels[i] == sensor::kUnlabeled;
    sketch[i / raster.frame.width] += nothing ? '.'
                                      : seen  ? character
                                              : static_cast<char>(std::tolower(character));
  }
  return sketch;
}

io::RasterFrame WholeFrame(const map::Map& map, double resolution_m) {
  const auto frame = io::FrameOf(map, {}, {resolution_m, 4000, 0.});
  CHECK(frame.ok()) << frame.status();
  return *frame;
}

}  // namespace semantic_kiss_testing
