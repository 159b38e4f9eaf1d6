// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_LOCAL_TRAJECTORY_BUILDER_REGISTRY_H_
#define CARTOGRAPHER_SLAM_LOCAL_TRAJECTORY_BUILDER_REGISTRY_H_

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cartographer/sensor/label_set.h"
#include "cartographer/slam/local_trajectory_builder.h"

namespace google::protobuf {
class Message;
}

namespace cartographer::slam {

// The local trajectory builders that a program knows, by the name that its Lua files use. Filled by
// the program itself, so that what is linked in can be read in one place.
class LocalTrajectoryBuilderRegistry {
 public:
  // Makes a builder from its own options message, the type of which the plugin states.
  using Factory = std::function<absl::StatusOr<std::unique_ptr<LocalTrajectoryBuilder>>(
      const google::protobuf::Message& options, const sensor::LabelSet& labels)>;

  // A name may be registered once (CHECKed).
  void Register(const std::string& name, Factory factory);

  // Picks a builder by `options`, a message with a string field `name` and, for every builder, a
  // field of that builder's name which holds its options:
  //
  //   local_trajectory_builder = { name = "semantic_kiss", semantic_kiss = { ... } }
  //
  // Errors: a name that is not registered (the message lists those that are), no such field.
  absl::StatusOr<std::unique_ptr<LocalTrajectoryBuilder>> Create(
      const google::protobuf::Message& options, const sensor::LabelSet& labels) const;

 private:
  std::map<std::string, Factory> factories_;
};

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_LOCAL_TRAJECTORY_BUILDER_REGISTRY_H_
