// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/testing/odometry_on_sequence.h"

#include <utility>

#include "cartographer/common/options_loader.h"
#include "glog/logging.h"
#include "semantic_kiss/dataset/semantic_kitti_source.h"
#include "test/testing/test_files.h"

namespace semantic_kiss_testing {

semantic_kiss::proto::SemanticKissOptions ShippedOptions(const std::string& overrides) {
  semantic_kiss::proto::SemanticKissOptions options;
  const absl::Status status = cartographer::common::LoadOptionsFromString(
      "include \"defaults/semantic_kiss_builder.lua\"\n"
      "local options = SEMANTIC_KISS_BUILDER\n" +
          overrides + "\nreturn options\n",
      "overrides of a test", {SourceFile("configuration_files")}, &options);
  CHECK(status.ok()) << status;
  return options;
}

cartographer::sensor::LabelSet ShippedLabels() {
  cartographer::sensor::proto::LabelSet declaration;
  const absl::Status status = cartographer::common::LoadOptions(
      {SourceFile("configuration_files/labels/semantic_kitti.lua"), {}}, &declaration);
  CHECK(status.ok()) << status;
  const auto labels = cartographer::sensor::LabelSet::Create(declaration);
  CHECK(labels.ok()) << labels.status();
  return *labels;
}

std::vector<cartographer::sensor::LabeledScan> ReadScans(const std::string& directory) {
  semantic_kiss::dataset::proto::DatasetOptions options;
  options.set_vertical_correction_deg(0.205);
  options.set_assumed_rate_hz(10.);
  const auto source = semantic_kiss::dataset::OpenSemanticKitti({directory, "00", ""}, {}, options,
                                                                ShippedLabels());
  CHECK(source.ok()) << source.status();
  std::vector<cartographer::sensor::LabeledScan> scans;
  for (int i = 0; i < (*source)->size(); ++i) {
    auto scan = (*source)->Read(i);
    CHECK(scan.ok()) << scan.status();
    scans.push_back(*std::move(scan));
  }
  return scans;
}

}  // namespace semantic_kiss_testing
