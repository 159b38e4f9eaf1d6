// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/map_stream.h"

#include <vector>

#include "cartographer/io/map_reader.h"
#include "cartographer/io/map_summary.h"
#include "cartographer/io/map_writer.h"
#include "cartographer/io/record_writer.h"
#include "glog/logging.h"
#include "test/testing/small_map.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using mapping::proto::SerializationHeader;
using mapping::proto::SerializedData;
using semantic_kiss_testing::SmallMap;
using semantic_kiss_testing::TemporaryDirectory;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The records of a map, to be changed and written again.
class MapStreamTest : public ::testing::Test {
 protected:
  MapStreamTest() {
    CHECK(WriteMap(SmallMap(2, 5), path_).ok());
    absl::StatusOr<RecordReader> reader = RecordReader::Open(path_);
    CHECK(ForEachRecord(
              &*reader, [](const CompressedRecord& record) { return record.Decompress(); },
              [this](const CompressedRecord& record, const std::string& bytes) {
                if (record.number == 0) {
                  CHECK(header_.ParseFromString(bytes));
                } else {
                  CHECK(records_.emplace_back().ParseFromString(bytes));
                }
                return absl::OkStatus();
              })
              .ok());
    CHECK_EQ(records_.size(), 8u);  // pose graph, options, 2 submaps, 4 nodes
  }

  void Write() {
    absl::StatusOr<RecordWriter> writer = RecordWriter::Create(path_);
    CHECK(writer->Write(header_).ok());
    for (const SerializedData& record : records_) CHECK(writer->Write(record).ok());
    CHECK(writer->Commit().ok());
  }

  // Writes the records; the error on reading them without the path, "" if there is none.
  std::string Error() {
    Write();
    const absl::Status status = ReadMap(path_).status();
    const absl::Status summary_status = ReadMapSummary(path_).status();
    EXPECT_TRUE(status == summary_status || absl::IsUnimplemented(status)) << summary_status;
    if (status.ok()) return "";
    EXPECT_EQ(status.message().substr(0, path_.size() + 2), path_ + ": ");
    return std::string(status.message().substr(path_.size() + 2));
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_ / "map.pbstream";
  SerializationHeader header_;
  std::vector<SerializedData> records_;
};

TEST_F(MapStreamTest, OrderOfTheFirstRecords) {
  header_.set_format_version(3);
  EXPECT_EQ(Error(), "its format version 3 is not 1 or 2");
  header_.set_format_version(1);
  EXPECT_EQ(Error(), "");
  std::swap(records_[0], records_[1]);
  EXPECT_EQ(Error(), "the second record is not the pose graph");
  std::swap(records_[0], records_[1]);
  std::swap(records_[1], records_[2]);
  EXPECT_EQ(Error(), "the third record does not hold options for each of the 2 trajectories");
  records_.resize(1);
  EXPECT_EQ(Error(), "the file ends before the record of the options of trajectories");
  records_.clear();
  EXPECT_EQ(Error(), "the file ends before the record of the pose graph");
}

TEST_F(MapStreamTest, OneEntryOfOptionsATrajectory) {
  records_[1].mutable_all_trajectory_builder_options()->add_options_with_sensor_ids();
  EXPECT_EQ(Error(), "the third record does not hold options for each of the 2 trajectories");
}

TEST_F(MapStreamTest, ElementsComeOnceAndAsListed) {
  std::swap(records_[2], records_[7]);  // in any order
  EXPECT_EQ(Error(), "");
  const SerializedData last = records_.back();
  records_.push_back(last);
  EXPECT_THAT(Error(), HasSubstr("submap (1, 0) comes twice"));
  EXPECT_THAT(Error(), HasSubstr("record 9 at byte "));
  records_.resize(7);
  EXPECT_EQ(Error(), "the file ends before submap (1, 0), which its pose graph lists");
  records_.push_back(last);
  records_[3].mutable_submap()->mutable_submap_id()->set_submap_index(9);
  EXPECT_THAT(Error(), HasSubstr("submap (4, 9) is not listed in the pose graph"));
}

TEST_F(MapStreamTest, TimesAgree) {
  records_[4].mutable_node()->mutable_node_data()->set_timestamp(5);
  EXPECT_THAT(Error(), HasSubstr("node (1, 3) has another time stamp than in the pose graph"));
}

TEST_F(MapStreamTest, SecondPoseGraphsAreRefused) {
  records_.push_back(records_[0]);
  EXPECT_THAT(Error(), HasSubstr("is a second pose graph"));
}

TEST_F(MapStreamTest, BadLabelSetsAreRefused) {
  header_.mutable_description()->mutable_labels()->mutable_classes(1)->set_id(0);
  EXPECT_THAT(Error(), HasSubstr("label set: "));
  // Without the set, labels are beyond it.
  header_.mutable_description()->clear_labels();
  EXPECT_THAT(Error(), HasSubstr("layer of label 1: not in the label set of 1"));
}

TEST_F(MapStreamTest, ElementsAreChecked) {
  records_[2].mutable_submap()->mutable_submap_2d()->set_num_range_data(-1);
  EXPECT_THAT(Error(), HasSubstr("submap (1, 0): has -1 scans"));
  records_[2].mutable_submap()->mutable_submap_2d()->clear_local_pose();
  EXPECT_THAT(Error(), HasSubstr("submap (1, 0): "));
}

TEST_F(MapStreamTest, OtherSubmapsCanBeCountedOnly) {
  records_[3].mutable_submap()->clear_submap_2d();
  records_[3].mutable_submap()->mutable_submap_3d();
  EXPECT_THAT(Error(), HasSubstr("submap (4, 0): is not 2D"));
  const auto summary = ReadMapSummary(path_);
  ASSERT_TRUE(summary.ok()) << summary.status();
  EXPECT_EQ(summary->num_unsupported_submaps, 1);
}

TEST_F(MapStreamTest, RecordsThatAMapDoesNotKeepArePassedOver) {
  records_.emplace_back().mutable_imu_data()->set_trajectory_id(1);
  records_.emplace_back().mutable_landmark_data();
  records_.emplace_back();
  EXPECT_EQ(Error(), "");
}

TEST_F(MapStreamTest, WithoutOurFieldsItIsAMapOfCartographer) {
  header_.clear_description();
  for (SerializedData& record : records_) {
    if (record.has_submap()) record.mutable_submap()->clear_semantic();
    if (record.has_node()) record.mutable_node()->clear_point_attributes();
  }
  EXPECT_EQ(Error(), "");
  const auto map = ReadMap(path_);
  EXPECT_EQ(map->nodes.size(), 4u);
  for (const auto& [id, node] : map->nodes) EXPECT_EQ(node.cloud->size(), 5u);
  for (const auto& [id, submap] : map->submaps) {
    EXPECT_THAT(submap.submap->grid.Labels(), ElementsAre(sensor::kUnlabeled));
  }
}

TEST_F(MapStreamTest, SummaryCountsEverything) {
  const auto summary = ReadMapSummary(path_);
  ASSERT_TRUE(summary.ok()) << summary.status();
  const map::Map map = SmallMap(2, 5);
  EXPECT_TRUE(summary->made_by_us);
  EXPECT_EQ(summary->format_version, 2);
  EXPECT_EQ(summary->history, map.history);
  EXPECT_EQ(summary->num_intra_constraints, 4);
  EXPECT_EQ(summary->num_inter_constraints, 1);
  std::vector<std::string> kinds;
  uint64_t bytes = 8;
  for (const MapSummary::Kind& kind : summary->kinds) {
    kinds.push_back(kind.name);
    bytes += kind.stored_bytes;
  }
  EXPECT_THAT(kinds, ElementsAre("header", "pose_graph", "all_trajectory_builder_options", "submap",
                                 "node"));
  EXPECT_EQ(bytes, summary->file_bytes);
  ASSERT_EQ(summary->trajectories.size(), 2u);
  EXPECT_EQ(summary->trajectories[1].id, 4);
  EXPECT_EQ(summary->trajectories[1].num_nodes, 2);
  const map::MapNode& first = map.nodes.at({4, 3});
  const map::MapNode& last = map.nodes.at({4, 4});
  EXPECT_EQ(summary->trajectories[1].first_time, first.time);
  EXPECT_EQ(summary->trajectories[1].last_time, last.time);
  EXPECT_DOUBLE_EQ(summary->trajectories[1].length_m,
                   (last.map_from_node.translation() - first.map_from_node.translation()).norm());
  EXPECT_TRUE(summary->node_bounds_m.contains(first.map_from_node.translation()));

  std::vector<map::LabelCount> expected(5);
  for (const auto& [id, node] : map.nodes) {
    for (const sensor::Label label : node.cloud->labels) {
      ++expected[sensor::Index(label)].node_points;
    }
  }
  for (const auto& [id, submap] : map.submaps) {
    for (size_t i = 0; i < submap.submap->cloud.size(); ++i) {
      const sensor::Label label = submap.submap->cloud.labels[i];
      ++expected[sensor::Index(label)].submap_points;
      const Eigen::Vector3d point =
          submap.map_from_submap * submap.submap->cloud.positions[i].cast<double>();
      EXPECT_TRUE(summary->grid_bounds_m.contains(point.head<2>()));
    }
    for (const sensor::Label label : submap.submap->grid.Labels()) {
      for (const auto& [index, tile] : submap.submap->grid.LayerOf(label)) {
        for (const uint16_t hits : tile->hits) expected[sensor::Index(label)].hits += hits;
      }
    }
  }
  ASSERT_EQ(summary->label_counts.size(), 5u);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(summary->label_counts[i].hits, expected[i].hits);
    EXPECT_EQ(summary->label_counts[i].submap_points, expected[i].submap_points);
    EXPECT_EQ(summary->label_counts[i].node_points, expected[i].node_points);
  }
}

}  // namespace
}  // namespace cartographer::io
