// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/snapshot_json.h"

#include <cmath>

#include "glog/logging.h"

namespace semantic_kiss::live {
namespace {

using Json = nlohmann::ordered_json;

Json Decimetres(double position_m) {
  return std::isfinite(position_m) ? Json(std::round(10. * position_m) / 10.) : Json();
}

}  // namespace

const char* NameOf(Phase phase) {
  switch (phase) {
    case Phase::kDriving:
      return "driving";
    case Phase::kConcluding:
      return "concluding";
    case Phase::kDone:
      return "done";
    case Phase::kStopped:
      return "stopped";
  }
  LOG(FATAL) << "unknown phase " << static_cast<int>(phase);
}

Json SnapshotJson(const Snapshot& snapshot) {
  Json json = {{"done", snapshot.done},
               {"total", snapshot.total},
               {"elapsed_s", snapshot.elapsed_s},
               {"error_m", snapshot.error_m ? Json(*snapshot.error_m) : Json()},
               {"memory_mib", snapshot.memory_mib},
               {"nodes", snapshot.num_nodes},
               {"submaps", snapshot.submaps.size()},
               {"outcomes", snapshot.outcomes},
               {"candidates", snapshot.num_candidates},
               {"stages", Json::array()}};
  for (const Snapshot::Stage& stage : snapshot.stages) {
    json["stages"].push_back(
        {{"name", stage.name}, {"mean_ms", stage.mean_ms}, {"total_s", stage.total_s}});
  }
  Json x = Json::array(), y = Json::array(), closures = Json::array();
  for (const Eigen::Vector2d& position : snapshot.path) {
    x.push_back(Decimetres(position.x()));
    y.push_back(Decimetres(position.y()));
  }
  for (const Snapshot::Closure& closure : snapshot.closures) {
    closures.push_back(
        Json::array({Decimetres(closure.node.x()), Decimetres(closure.node.y()),
                     Decimetres(closure.submap.x()), Decimetres(closure.submap.y())}));
  }
  json["path"] = {{"x", std::move(x)}, {"y", std::move(y)}};
  json["closures"] = std::move(closures);
  return json;
}

}  // namespace semantic_kiss::live
