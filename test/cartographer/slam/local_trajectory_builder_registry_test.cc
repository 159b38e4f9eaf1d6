// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/slam/local_trajectory_builder_registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cartographer/sensor/proto/label_set.pb.h"

namespace cartographer::slam {
namespace {

using testing::HasSubstr;

class IdleBuilder : public LocalTrajectoryBuilder {
 public:
  LocalResult AddScan(const sensor::LabeledScan&) override { return {}; }
  void Finish() override {}
};

LocalTrajectoryBuilderRegistry::Factory IdleFactory() {
  return [](const google::protobuf::Message&,
            const sensor::LabelSet&) -> absl::StatusOr<std::unique_ptr<LocalTrajectoryBuilder>> {
    return std::make_unique<IdleBuilder>();
  };
}

// A message with a field `name` and no field for any builder.
sensor::proto::LabelSet Named(const std::string& name) {
  sensor::proto::LabelSet options;
  options.set_name(name);
  return options;
}

TEST(LocalTrajectoryBuilderRegistryTest, UnknownNamesListTheKnownOnes) {
  LocalTrajectoryBuilderRegistry registry;
  registry.Register("idle", IdleFactory());
  registry.Register("busy", IdleFactory());
  const auto builder = registry.Create(Named("lazy"), sensor::LabelSet());
  ASSERT_FALSE(builder.ok());
  EXPECT_THAT(std::string(builder.status().message()), HasSubstr("\"lazy\" is not known"));
  EXPECT_THAT(std::string(builder.status().message()), HasSubstr("busy, idle"));
}

TEST(LocalTrajectoryBuilderRegistryTest, ABuilderNeedsItsOptions) {
  LocalTrajectoryBuilderRegistry registry;
  registry.Register("idle", IdleFactory());
  const auto builder = registry.Create(Named("idle"), sensor::LabelSet());
  ASSERT_FALSE(builder.ok());
  EXPECT_THAT(std::string(builder.status().message()), HasSubstr("no options table 'idle'"));
}

TEST(LocalTrajectoryBuilderRegistryDeathTest, NamesAreTakenOnce) {
  LocalTrajectoryBuilderRegistry registry;
  registry.Register("idle", IdleFactory());
  EXPECT_DEATH(registry.Register("idle", IdleFactory()), "registered twice");
}

}  // namespace
}  // namespace cartographer::slam
