// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/option_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "cartographer/pose_graph/proto/pose_graph_options.pb.h"
#include "glog/logging.h"
#include "google/protobuf/descriptor.pb.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::manual {
namespace {

using cartographer::pose_graph::proto::AgreementOptions;
using cartographer::pose_graph::proto::PlaceRecognitionOptions;
using google::protobuf::FileDescriptorProto;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Comments on every message and field of a file: "About NAME. More." It is what protoc would have
// written, but for the text.
OptionComments CommentsOn(const std::vector<const google::protobuf::FileDescriptor*>& sources) {
  google::protobuf::FileDescriptorSet files;
  for (const auto* source : sources) {
    FileDescriptorProto& file = *files.add_file();
    source->CopyTo(&file);
    for (int i = 0; i < file.message_type_size(); ++i) {
      const auto add = [&](std::vector<int> path, const std::string& name) {
        auto& location = *file.mutable_source_code_info()->add_location();
        for (const int step : path) location.add_path(step);
        location.set_leading_comments(" About " + name + ".\n More <b> of 2 * 3.\n");
      };
      add({4, i}, file.message_type(i).name());
      for (int j = 0; j < file.message_type(i).field_size(); ++j) {
        add({4, i, 2, j}, file.message_type(i).field(j).name());
      }
    }
  }
  const semantic_kiss_testing::TemporaryDirectory directory;
  semantic_kiss_testing::WriteText(directory / "descriptors.pb", files.SerializeAsString());
  const auto comments = OptionComments::Read(directory / "descriptors.pb");
  CHECK(comments.ok()) << comments.status();
  return *comments;
}

template <typename Options>
std::vector<OptionTree> TreeOf(const Options& defaults, const Options& system) {
  std::vector<OptionTree> trees(1);
  trees[0].commands = "`run`";
  trees[0].defaults = {"defaults/run.lua", std::make_unique<Options>(defaults)};
  trees[0].systems.push_back({"system.lua", std::make_unique<Options>(system)});
  return trees;
}

std::string ReferenceOf(const std::vector<OptionTree>& trees) {
  const auto text = OptionReference(
      trees, CommentsOn({AgreementOptions::descriptor()->file(),
                         cartographer::scan_matching::proto::LabelGroup::descriptor()->file(),
                         PlaceRecognitionOptions::descriptor()->file()}));
  CHECK(text.ok()) << text.status();
  return *text;
}

TEST(OptionReferenceTest, TellsValueTypeRangeUnitMeaningAndWhoChangesIt) {
  AgreementOptions defaults, system;
  defaults.set_max_distance_m(0.5);
  system.set_max_distance_m(0.5);
  system.set_max_angle_deg(2.5);
  EXPECT_THAT(ReferenceOf(TreeOf(defaults, system)),
              AllOf(HasSubstr("- **`max_distance_m`** = `0.5` (a number with 0 <= x <= 100, in m)"
                              "<br>\n  About max_distance_m. More \\<b> of 2 \\* 3.\n- "),
                    HasSubstr("- **`max_angle_deg`** = `0` (a number with 0 <= x <= 180, in deg)"
                              "<br>\n  About max_angle_deg. More \\<b> of 2 \\* 3.<br>\n"
                              "  In `system.lua`: `2.5`\n")));
}

TEST(OptionReferenceTest, ElementsOfListsStandSideBySide) {
  PlaceRecognitionOptions defaults;
  const std::string none = ReferenceOf(TreeOf(defaults, defaults));
  EXPECT_THAT(none, AllOf(HasSubstr("\n### `groups[]`\n"), HasSubstr("(#groups)"),
                          HasSubstr("- **`groups[].weight`** = none (a number")));
  PlaceRecognitionOptions system;
  system.add_groups()->set_weight(1);
  system.add_groups()->set_weight(3);
  EXPECT_THAT(ReferenceOf(TreeOf(defaults, system)), HasSubstr("In `system.lua`: `1, 3`\n"));
}

TEST(OptionReferenceTest, NamesWhatHasNoComment) {
  const auto text = OptionReference(TreeOf(AgreementOptions(), AgreementOptions()), {});
  EXPECT_THAT(std::string(text.status().message()),
              AllOf(HasSubstr("need a comment"),
                    HasSubstr("cartographer.pose_graph.proto.AgreementOptions.max_travel_m")));
}

TEST(OptionCommentsTest, RefusesWhatIsNoDescriptorSet) {
  EXPECT_FALSE(OptionComments::Read("/nonexistent/descriptors.pb").ok());
  EXPECT_FALSE(OptionComments::Read("/proc/self/exe").ok());
}

}  // namespace
}  // namespace semantic_kiss::manual
