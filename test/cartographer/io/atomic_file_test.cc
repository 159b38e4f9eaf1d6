// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/atomic_file.h"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace cartographer::io {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class AtomicFileTest : public ::testing::Test {
 protected:
  AtomicFileTest() {
    directory_ = fs::temp_directory_path() / ("atomic_file_test_" + std::to_string(::getpid()));
    fs::create_directory(directory_);
  }
  ~AtomicFileTest() override { fs::remove_all(directory_); }

  std::string Path(const std::string& name) const { return (directory_ / name).string(); }

  static std::string Content(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }

  int NumFiles() const {
    return static_cast<int>(
        std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }

  fs::path directory_;
};

TEST_F(AtomicFileTest, WritesAndReplaces) {
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "one").ok());
  EXPECT_EQ(Content(Path("a")), "one");
  ASSERT_TRUE(WriteFileAtomically(Path("a"), std::string("t\0o", 3)).ok());
  EXPECT_EQ(Content(Path("a")), std::string("t\0o", 3));
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "").ok());
  EXPECT_EQ(Content(Path("a")), "");
  EXPECT_EQ(NumFiles(), 1);
}

TEST_F(AtomicFileTest, NothingShowsBeforeCommit) {
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "old").ok());
  auto file = AtomicFile::Create(Path("a"));
  ASSERT_TRUE(file.ok());
  std::string expected;
  for (int i = 0; i < 100000; ++i) {
    ASSERT_TRUE(file->Write("0123456789").ok());
    expected += "0123456789";
  }
  EXPECT_EQ(file->size(), 1000000u);
  EXPECT_EQ(Content(Path("a")), "old");
  ASSERT_TRUE(file->Commit().ok());
  EXPECT_EQ(Content(Path("a")), expected);
  EXPECT_EQ(NumFiles(), 1);
}

TEST_F(AtomicFileTest, AbandonedFileLeavesNothing) {
  {
    auto file = AtomicFile::Create(Path("a"));
    ASSERT_TRUE(file.ok());
    ASSERT_TRUE(file->Write("half").ok());
    EXPECT_EQ(NumFiles(), 1);
    AtomicFile moved = *std::move(file);
    AtomicFile other = *AtomicFile::Create(Path("b"));
    EXPECT_EQ(NumFiles(), 2);
    other = std::move(moved);  // abandons b
    EXPECT_EQ(NumFiles(), 1);
  }
  EXPECT_EQ(NumFiles(), 0);
}

TEST_F(AtomicFileTest, MovedFileCommits) {
  auto created = AtomicFile::Create(Path("a"));
  ASSERT_TRUE(created.ok());
  ASSERT_TRUE(created->Write("be").ok());
  AtomicFile file = *std::move(created);
  ASSERT_TRUE(file.Write("fore").ok());
  ASSERT_TRUE(file.Commit().ok());
  EXPECT_EQ(Content(Path("a")), "before");
}

TEST_F(AtomicFileTest, FollowsSymbolicLinks) {
  ASSERT_TRUE(WriteFileAtomically(Path("real"), "old").ok());
  fs::create_symlink("real", Path("link"));
  ASSERT_TRUE(WriteFileAtomically(Path("link"), "new").ok());
  EXPECT_TRUE(fs::is_symlink(Path("link")));
  EXPECT_EQ(Content(Path("real")), "new");
}

TEST_F(AtomicFileTest, ErrorsNameThePathAndTheReason) {
  const absl::Status missing = WriteFileAtomically(Path("none/a"), "x");
  EXPECT_EQ(missing.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(missing.message()),
              AllOf(HasSubstr(Path("none/a")), HasSubstr("No such file or directory")));

  const absl::Status directory = WriteFileAtomically(directory_.string(), "x");
  EXPECT_THAT(std::string(directory.message()), HasSubstr("Is a directory"));

  const absl::Status device = WriteFileAtomically("/dev/null", "x");
  EXPECT_THAT(std::string(device.message()), HasSubstr("/dev/null: is not a regular file"));

  EXPECT_FALSE(WriteFileAtomically("", "x").ok());
  EXPECT_FALSE(WriteFileAtomically(Path("a/"), "x").ok());
  EXPECT_EQ(NumFiles(), 0);
}

// A limit on file sizes stands for a disk that fills up in the middle of a file.
TEST_F(AtomicFileTest, FailedWriteKeepsTheOldFileAndRemovesTheTemporary) {
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "old").ok());
  struct rlimit old_limit;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit limit = old_limit;
  limit.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  auto file = AtomicFile::Create(Path("a"));
  const absl::Status write = file->Write(std::string(1 << 20, 'x'));
  const absl::Status commit = file->Commit();
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);

  EXPECT_THAT(std::string(write.message()),
              HasSubstr(Path("a") + ": cannot write: File too large"));
  EXPECT_EQ(commit, write);
  EXPECT_EQ(Content(Path("a")), "old");
  EXPECT_EQ(NumFiles(), 1);
}

TEST_F(AtomicFileTest, FilesOfASetAppearTogether) {
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "old").ok());
  AtomicFileSet set;
  ASSERT_TRUE(WriteFileAtomically({Path("a"), &set}, "new").ok());
  ASSERT_TRUE(WriteFileAtomically({Path("b"), &set}, "also new").ok());
  EXPECT_EQ(Content(Path("a")), "old");
  EXPECT_EQ(NumFiles(), 3);
  ASSERT_TRUE(set.Commit().ok());
  EXPECT_EQ(Content(Path("a")), "new");
  EXPECT_EQ(Content(Path("b")), "also new");
  EXPECT_EQ(NumFiles(), 2);
  EXPECT_TRUE(set.Commit().ok());
}

TEST_F(AtomicFileTest, ASetThatIsNotCommittedLeavesNothing) {
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "old").ok());
  {
    AtomicFileSet set;
    ASSERT_TRUE(WriteFileAtomically({Path("a"), &set}, "new").ok());
    EXPECT_FALSE(WriteFileAtomically({Path("nowhere/b"), &set}, "new").ok());
  }
  EXPECT_EQ(Content(Path("a")), "old");
  EXPECT_EQ(NumFiles(), 1);
}

TEST_F(AtomicFileTest, NothingFollowsTheCommit) {
  AtomicFileSet set;
  for (AtomicFileSet* const of : {static_cast<AtomicFileSet*>(nullptr), &set}) {
    auto file = AtomicFile::Create({Path("a"), of});
    ASSERT_TRUE(file->Commit().ok());
    EXPECT_DEATH(static_cast<void>(file->Write("more")), "written to after its end");
    EXPECT_DEATH(static_cast<void>(file->Commit()), "committed twice");
  }
}

// A process that may open no further file cannot open the directory to make the name durable.
TEST_F(AtomicFileTest, ADirectoryThatCannotBeMadeDurableIsAnErrorButTheFileIsThere) {
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "old").ok());
  auto file = AtomicFile::Create(Path("a"));
  ASSERT_TRUE(file->Write("new").ok());
  struct rlimit old_limit;
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &old_limit), 0);
  struct rlimit limit = old_limit;
  limit.rlim_cur = 0;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &limit), 0);
  const absl::Status commit = file->Commit();
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &old_limit), 0);

  EXPECT_THAT(std::string(commit.message()),
              AllOf(HasSubstr(Path("a") + ": cannot write its directory to the disk: Too many"),
                    HasSubstr("may be gone again after a power cut")));
  EXPECT_EQ(Content(Path("a")), "new");
  EXPECT_EQ(NumFiles(), 1);
}

// As a process does that is told to end at once; it runs in a child here.
TEST_F(AtomicFileTest, AbandoningRemovesAllTemporaryFilesAndNoOthers) {
  ASSERT_TRUE(WriteFileAtomically(Path("a"), "old").ok());
  EXPECT_EXIT(
      {
        auto first = AtomicFile::Create(Path("a"));
        auto second = AtomicFile::Create(Path("b"));
        if (!first->Write(std::string(1 << 20, 'x')).ok() || NumFiles() != 3) ::_exit(1);
        AbandonAtomicFiles();
        ::_exit(NumFiles() == 1 && Content(Path("a")) == "old" ? 0 : 2);
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace cartographer::io
