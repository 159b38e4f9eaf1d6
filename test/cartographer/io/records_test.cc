// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "cartographer/io/gzip.h"
#include "cartographer/io/parse_message.h"
#include "cartographer/io/record_format.h"
#include "cartographer/io/record_reader.h"
#include "cartographer/io/record_writer.h"
#include "cartographer/mapping/proto/serialization.pb.h"
#include "test/cartographer/io/memory_peak.h"
#include "test/testing/test_files.h"

namespace cartographer::io {
namespace {

using mapping::proto::NodeId;
using semantic_kiss_testing::ReadText;
using semantic_kiss_testing::TemporaryDirectory;
using semantic_kiss_testing::WriteText;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string Integer(uint64_t value) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>(value >> 8 * i));
  return bytes;
}

std::string Record(const std::string& message) {
  const std::string member = GzipCompress(message);
  return Integer(member.size()) + member;
}

class RecordsTest : public ::testing::Test {
 protected:
  // Reads all records of a file of these bytes; the error, "" if there is none.
  std::string ReadAll(const std::string& bytes, std::vector<std::string>* messages = nullptr) {
    WriteText(path_, bytes);
    const MemoryPeak peak;
    absl::StatusOr<RecordReader> reader = RecordReader::Open(path_);
    if (!reader.ok()) return std::string(reader.status().message());
    const absl::Status status = ForEachRecord(
        &*reader, [](const CompressedRecord& record) { return record.Decompress(); },
        [messages](const CompressedRecord&, const std::string& message) {
          if (messages != nullptr) messages->push_back(message);
          return absl::OkStatus();
        });
    peak_bytes_ = peak.bytes();
    return std::string(status.message());
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_ / "records";
  size_t peak_bytes_ = 0;
};

TEST_F(RecordsTest, WrittenRecordsComeBackInOrder) {
  absl::StatusOr<RecordWriter> writer = RecordWriter::Create(path_);
  ASSERT_TRUE(writer.ok());
  NodeId first;
  first.set_node_index(-1);
  ASSERT_TRUE(writer->Write(first).ok());
  ASSERT_TRUE(writer
                  ->Write<NodeId>(100,
                                  [](size_t i) -> absl::StatusOr<NodeId> {
                                    NodeId id;
                                    id.set_node_index(static_cast<int>(i));
                                    return id;
                                  })
                  .ok());
  ASSERT_TRUE(writer->Commit().ok());
  std::vector<std::string> messages;
  EXPECT_EQ(ReadAll(ReadText(path_), &messages), "");
  ASSERT_EQ(messages.size(), 101u);
  for (int i = 0; i <= 100; ++i) {
    NodeId id;
    ASSERT_TRUE(ParseMessage(messages[i], &id).ok());
    EXPECT_EQ(id.node_index(), i - 1);
  }
}

TEST_F(RecordsTest, AnErrorOfTheMakerEndsTheFile) {
  absl::StatusOr<RecordWriter> writer = RecordWriter::Create(path_);
  ASSERT_TRUE(writer.ok());
  const absl::Status status = writer->Write<NodeId>(3, [](size_t i) -> absl::StatusOr<NodeId> {
    if (i > 0) return absl::InvalidArgumentError(absl::StrCat("no ", i));
    return NodeId();
  });
  EXPECT_EQ(std::string(status.message()), path_ + ": no 1");
}

TEST_F(RecordsTest, MessagesOverTheLimitAreNotWritten) {
  absl::StatusOr<RecordWriter> writer = RecordWriter::Create(path_);
  ASSERT_TRUE(writer.ok());
  mapping::proto::SerializationHeader header;
  header.mutable_description()->set_configuration_lua(std::string(kMaxMessageSize - 100, 'x'));
  EXPECT_TRUE(writer->Write(header).ok());
  header.mutable_description()->mutable_configuration_lua()->append(100, 'x');
  EXPECT_THAT(std::string(writer->Write(header).message()),
              AllOf(HasSubstr(path_ + ": a record of "), HasSubstr("over the 67108864")));
}

TEST_F(RecordsTest, WhatIsNoFileOfRecordsIsToldApart) {
  EXPECT_THAT(std::string(RecordReader::Open(directory_ / "none").status().message()),
              HasSubstr("none: no such file"));
  EXPECT_THAT(std::string(RecordReader::Open(directory_ / "").status().message()),
              HasSubstr("is not a regular file"));
  for (const std::string& bytes : {std::string(), std::string("\xdb\x01\xf5\x5b"), Integer(1),
                                   std::string("P5 2 2 255 abcd")}) {
    EXPECT_THAT(ReadAll(bytes), HasSubstr("does not start with the magic number"));
  }
  EXPECT_EQ(ReadAll(Integer(kMagic)), "");
}

TEST_F(RecordsTest, ErrorsNameRecordAndOffset) {
  const std::string start = Integer(kMagic) + Record("one") + Record("two");
  const std::string place = path_ + ": record 2 at byte " + std::to_string(start.size()) + ": ";
  EXPECT_EQ(ReadAll(start), "");
  EXPECT_THAT(ReadAll(start + "\1\2"),
              HasSubstr(place + "needs 8 more bytes, but only 2 are left"));
  EXPECT_THAT(ReadAll(start + Integer(5) + "abcd"),
              HasSubstr(place + "needs 5 more bytes, but only 4 are left"));
  EXPECT_THAT(ReadAll(start + Integer(4) + "abcd"), HasSubstr(place + "is damaged"));
  EXPECT_THAT(ReadAll(start + Integer(0)), HasSubstr(place + "is damaged"));
}

TEST_F(RecordsTest, AbsurdSizesTakeNoMemory) {
  for (const uint64_t size : {uint64_t{1} << 60, ~uint64_t{0}, uint64_t{1} << 32}) {
    EXPECT_THAT(ReadAll(Integer(kMagic) + Integer(size) + "abcd"),
                HasSubstr("needs " + std::to_string(size) + " more bytes, but only 4 are left"));
    EXPECT_LT(peak_bytes_, 100'000u);
  }
}

TEST_F(RecordsTest, BombsAreRefused) {
  const std::string large = Record(std::string(kMaxMessageSize + 1, '\0'));
  EXPECT_THAT(ReadAll(Integer(kMagic) + large), HasSubstr("more than the 67108864 allowed"));
  EXPECT_LT(peak_bytes_, 1'000'000u);

  // Each is within the limit of a record, but the file expands a thousandfold.
  const std::string bomb = Record(std::string(30'000'000, '\0'));
  EXPECT_EQ(ReadAll(Integer(kMagic) + bomb), "");
  EXPECT_THAT(ReadAll(Integer(kMagic) + bomb + bomb + bomb + bomb),
              HasSubstr("decompress to over 200 times the file's size"));
}

TEST_F(RecordsTest, GroupsAreRefusedUnparsed) {
  // An unknown group of a million empty ones.
  std::string groups = "\xa3\x06";
  for (int i = 0; i < 1000000; ++i) groups += "\x0b\x0c";
  groups += "\xa4\x06";
  mapping::proto::PoseGraph graph;
  const MemoryPeak peak;
  EXPECT_THAT(std::string(ParseMessage(groups, &graph).message()),
              HasSubstr("is no message of type"));
  EXPECT_LT(peak.bytes(), 1'000'000u);
}

TEST_F(RecordsTest, EmptyMessagesByTheMillionAreRefusedUnparsed) {
  std::string constraints;
  for (int i = 0; i < 1000000; ++i) constraints += std::string("\x12\0", 2);
  mapping::proto::PoseGraph graph;
  const MemoryPeak peak;
  EXPECT_THAT(std::string(ParseMessage(constraints, &graph).message()),
              HasSubstr("too many empty messages for its 2000000 bytes"));
  EXPECT_LT(peak.bytes(), 100'000u);

  EXPECT_TRUE(ParseMessage(constraints.substr(0, 2000), &graph).ok());
  EXPECT_EQ(graph.constraint_size(), 1000);
  EXPECT_THAT(std::string(ParseMessage("\x12\x05", &graph).message()),
              HasSubstr("is no message of type cartographer.mapping.proto.PoseGraph"));
}

}  // namespace
}  // namespace cartographer::io
