// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/common/status.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace cartographer::common {
namespace {

absl::StatusOr<std::unique_ptr<int>> MakeNumber(int number) {
  if (number < 0) return absl::OutOfRangeError("negative");
  return std::make_unique<int>(number);
}

absl::StatusOr<int> Sum(int a, int b) {
  ASSIGN_OR_RETURN(const std::unique_ptr<int> first, MakeNumber(a));
  std::unique_ptr<int> second;
  ASSIGN_OR_RETURN(second, MakeNumber(b));
  return *first + *second;
}

TEST(AssignOrReturnTest, MovesTheValueOrReturnsTheError) {
  ASSERT_TRUE(Sum(1, 2).ok());
  EXPECT_EQ(*Sum(1, 2), 3);
  EXPECT_EQ(Sum(-1, 2).status(), absl::OutOfRangeError("negative"));
  EXPECT_EQ(Sum(1, -2).status(), absl::OutOfRangeError("negative"));
}

absl::Status CountUntil(int* evaluations, const absl::Status& status, bool* went_on) {
  const auto evaluate = [&] {
    ++*evaluations;
    return status;
  };
  RETURN_IF_ERROR(evaluate());
  *went_on = true;
  return absl::OkStatus();
}

TEST(ReturnIfErrorTest, EvaluatesOnceAndReturnsTheError) {
  int evaluations = 0;
  bool went_on = false;
  EXPECT_EQ(CountUntil(&evaluations, absl::DataLossError("gone"), &went_on),
            absl::DataLossError("gone"));
  EXPECT_EQ(evaluations, 1);
  EXPECT_FALSE(went_on);
  EXPECT_TRUE(CountUntil(&evaluations, absl::OkStatus(), &went_on).ok());
  EXPECT_EQ(evaluations, 2);
  EXPECT_TRUE(went_on);
}

TEST(ReturnIfErrorTest, IsOneStatement) {
  const auto with_else = [](bool fail) -> absl::Status {
    if (fail)
      RETURN_IF_ERROR(absl::InternalError("failed"));
    else
      return absl::UnknownError("else");
    return absl::OkStatus();
  };
  EXPECT_EQ(with_else(true), absl::InternalError("failed"));
  EXPECT_EQ(with_else(false), absl::UnknownError("else"));
}

TEST(AddContextTest, PrefixesTheMessageAndKeepsTheCode) {
  const absl::Status status = AddContext(absl::NotFoundError("no such file"), "a.bin");
  EXPECT_EQ(status, absl::NotFoundError("a.bin: no such file"));
  EXPECT_EQ(AddContext(absl::OkStatus(), "a.bin"), absl::OkStatus());
}

}  // namespace
}  // namespace cartographer::common
