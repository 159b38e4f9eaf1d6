// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/dataset/prefetching_scan_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <string>

namespace semantic_kiss::dataset {
namespace {

using cartographer::sensor::LabeledScan;
using cartographer::sensor::LabelSet;
using cartographer::transform::Rigid3d;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

// Scan i has index i; its label file lists i points with the unknown id 100 + i. One scan fails;
// for another one there is no memory.
class FakeSource : public ScanSource {
 public:
  FakeSource(int size, int failing, int too_large = -1)
      : size_(size), failing_(failing), too_large_(too_large) {}

  int size() const override { return size_; }
  absl::StatusOr<LabeledScan> Read(int index) override {
    EXPECT_FALSE(reading_.exchange(true)) << "calls overlap";
    ++num_reads_;
    // Sometimes slower than the caller, sometimes faster.
    if (index % 3 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    reading_ = false;
    if (index == failing_) return absl::DataLossError("scan " + std::to_string(index));
    if (index == too_large_) throw std::bad_alloc();
    unknown_ids_[100 + index] += index;
    LabeledScan scan;
    scan.index = index;
    return scan;
  }
  const LabelSet& labels() const override { return labels_; }
  const std::optional<std::vector<Rigid3d>>& ground_truth() const override { return ground_truth_; }
  const std::optional<Rigid3d>& camera_from_sensor() const override { return camera_; }
  const UnknownLabelIds& unknown_label_ids() const override { return unknown_ids_; }
  const std::vector<std::string>& notes() const override { return notes_; }

  int num_reads() const { return num_reads_; }

 private:
  const int size_, failing_, too_large_;
  std::atomic<bool> reading_{false};
  std::atomic<int> num_reads_{0};
  LabelSet labels_;
  UnknownLabelIds unknown_ids_;
  std::optional<std::vector<Rigid3d>> ground_truth_ = std::vector<Rigid3d>(3);
  std::optional<Rigid3d> camera_ = Rigid3d::Translation({1., 2., 3.});
  std::vector<std::string> notes_ = {"a note"};
};

TEST(PrefetchingScanSourceTest, GivesScansAndErrorsInOrder) {
  PrefetchingScanSource source(std::make_unique<FakeSource>(20, 7));
  ASSERT_EQ(source.size(), 20);
  for (int i = 0; i < 20; ++i) {
    const absl::StatusOr<LabeledScan> scan = source.Read(i);
    ASSERT_EQ(scan.ok(), i != 7);
    if (scan.ok()) {
      EXPECT_EQ(scan->index, i);
    } else {
      EXPECT_EQ(scan.status().message(), "scan 7");
    }
    if (i % 4 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
}

TEST(PrefetchingScanSourceTest, EqualsTheSourceAloneForAnyCalls) {
  FakeSource alone(10, 4);
  PrefetchingScanSource ahead(std::make_unique<FakeSource>(10, 4));
  for (const int index : {0, 1, 2, 2, 5, 6, 3, 4, 5, 9, 9, 0, 8, 9}) {
    const absl::StatusOr<LabeledScan> expected = alone.Read(index);
    const absl::StatusOr<LabeledScan> scan = ahead.Read(index);
    ASSERT_EQ(scan.status(), expected.status());
    if (scan.ok()) {
      EXPECT_EQ(scan->index, expected->index);
    }
    EXPECT_EQ(ahead.unknown_label_ids(), alone.unknown_label_ids());
  }
}

TEST(PrefetchingScanSourceTest, ThrowsWhatTheSourceThrowsWhenThatScanIsAskedFor) {
  PrefetchingScanSource source(std::make_unique<FakeSource>(4, -1, 1));
  EXPECT_TRUE(source.Read(0).ok());
  EXPECT_THROW(static_cast<void>(source.Read(1)), std::bad_alloc);
  EXPECT_EQ(source.Read(2)->index, 2);
}

TEST(PrefetchingScanSourceTest, CountsOnlyWhatWasHandedOut) {
  PrefetchingScanSource source(std::make_unique<FakeSource>(10, -1));
  EXPECT_THAT(source.unknown_label_ids(), IsEmpty());
  ASSERT_TRUE(source.Read(1).ok());
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_THAT(source.unknown_label_ids(), ElementsAre(Pair(101, 1)));
}

TEST(PrefetchingScanSourceTest, LoadsAheadButNotTheWholeDrive) {
  auto owned = std::make_unique<FakeSource>(1000, -1);
  const FakeSource* const fake = owned.get();
  PrefetchingScanSource source(std::move(owned));
  EXPECT_EQ(fake->num_reads(), 0);
  ASSERT_TRUE(source.Read(0).ok());
  while (fake->num_reads() < 3) std::this_thread::yield();  // ahead without being asked
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(fake->num_reads(), 3);
}

TEST(PrefetchingScanSourceTest, EndsWhateverItIsDoing) {
  for (int num_reads = 0; num_reads <= 3; ++num_reads) {
    PrefetchingScanSource source(std::make_unique<FakeSource>(3, -1));
    for (int i = 0; i < num_reads; ++i) ASSERT_TRUE(source.Read(i).ok());
  }
  PrefetchingScanSource nothing(std::make_unique<FakeSource>(0, -1));
  EXPECT_EQ(nothing.size(), 0);
}

TEST(PrefetchingScanSourceTest, HandsOnTheRest) {
  const PrefetchingScanSource source(std::make_unique<FakeSource>(3, -1));
  EXPECT_EQ(source.ground_truth()->size(), 3);
  EXPECT_EQ(source.camera_from_sensor()->translation(), Eigen::Vector3d(1., 2., 3.));
  EXPECT_THAT(source.notes(), ElementsAre("a note"));
  EXPECT_EQ(source.labels().size(), 1);
}

}  // namespace
}  // namespace semantic_kiss::dataset
