// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "glog/logging.h"

namespace cartographer::io {
namespace {

namespace fs = std::filesystem;

constexpr size_t kBufferSize = 1 << 18;

// The temporary files that exist. They come and go only under the mutex, so that
// AbandonAtomicFiles() misses none. Never destroyed: files may outlive static storage.
std::mutex& TemporaryPathsMutex() {
  static auto& mutex = *new std::mutex;
  return mutex;
}
std::set<std::string>& TemporaryPaths() {
  static auto& paths = *new std::set<std::string>;
  return paths;
}

absl::Status SystemError(const std::string& path, const char* action, int error_number) {
  const bool full = error_number == ENOSPC || error_number == EDQUOT;
  return absl::Status(
      full ? absl::StatusCode::kResourceExhausted : absl::ErrnoToStatusCode(error_number),
      absl::StrCat(path, ": cannot ", action, ": ", std::strerror(error_number),
                   full ? " (disk full: free some space or write elsewhere)" : ""));
}

// Where bytes for `path` must finally go: links are followed, what is no file is refused.
absl::StatusOr<std::string> ResolveTarget(const std::string& path) {
  struct stat info;
  if (::stat(path.c_str(), &info) != 0) {
    if (errno != ENOENT) return SystemError(path, "open for writing", errno);
    return path;
  }
  if (S_ISDIR(info.st_mode)) return SystemError(path, "write", EISDIR);
  if (!S_ISREG(info.st_mode)) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": is not a regular file, so it cannot be replaced"));
  }
  std::error_code error;
  const fs::path resolved = fs::canonical(path, error);
  if (error) return SystemError(path, "resolve", error.value());
  return resolved.string();
}

fs::path DirectoryOf(const std::string& path) {
  const fs::path directory = fs::path(path).parent_path();
  return directory.empty() ? fs::path(".") : directory;
}

// The process's number keeps programs apart, the counter the files of one program. What an
// earlier process of the same number left behind is stepped over by O_EXCL.
std::string NextTemporaryPath(const std::string& target) {
  static std::atomic<uint32_t> counter{0};
  return (DirectoryOf(target) / absl::StrCat(".", fs::path(target).filename().string(), ".",
                                             ::getpid(), ".", counter++, ".tmp"))
      .string();
}

// A rename is durable only once the directory is on the disk, too.
int SyncDirectory(const fs::path& directory) {
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  // Some file systems cannot sync directories (EINVAL); they order renames by themselves.
  const int result = ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  ::close(descriptor);
  return result;
}

}  // namespace

AtomicFileSet::AtomicFileSet() = default;
AtomicFileSet::~AtomicFileSet() = default;

absl::Status AtomicFileSet::Commit() {
  for (AtomicFile& file : files_) RETURN_IF_ERROR(file.Publish());
  files_.clear();
  return absl::OkStatus();
}

absl::StatusOr<AtomicFile> AtomicFile::Create(const Destination& destination) {
  const std::string& path = destination.path;
  if (path.empty() || path.back() == '/') {
    return absl::InvalidArgumentError(absl::StrCat("'", path, "' does not name a file"));
  }
  ASSIGN_OR_RETURN(std::string target, ResolveTarget(path));
  while (true) {
    std::string temporary_path = NextTemporaryPath(target);
    const std::lock_guard<std::mutex> lock(TemporaryPathsMutex());
    const int descriptor =
        ::open(temporary_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      TemporaryPaths().insert(temporary_path);
      return AtomicFile(destination, std::move(target), std::move(temporary_path), descriptor);
    }
    if (errno != EEXIST && errno != EINTR) return SystemError(path, "create", errno);
  }
}

AtomicFile::AtomicFile(const Destination& destination, std::string target,
                       std::string temporary_path, int descriptor)
    : path_(destination.path),
      set_(destination.set),
      target_(std::move(target)),
      temporary_path_(std::move(temporary_path)),
      descriptor_(descriptor) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      set_(other.set_),
      target_(std::move(other.target_)),
      temporary_path_(std::exchange(other.temporary_path_, {})),
      buffer_(std::move(other.buffer_)),
      status_(std::move(other.status_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this == &other) return *this;
  Discard();
  path_ = std::move(other.path_);
  set_ = other.set_;
  target_ = std::move(other.target_);
  temporary_path_ = std::exchange(other.temporary_path_, {});
  buffer_ = std::move(other.buffer_);
  status_ = std::move(other.status_);
  descriptor_ = std::exchange(other.descriptor_, -1);
  size_ = other.size_;
  return *this;
}

AtomicFile::~AtomicFile() { Discard(); }

absl::Status AtomicFile::Write(absl::string_view bytes) {
  RETURN_IF_ERROR(status_);
  CHECK_GE(descriptor_, 0) << "written to after its end: " << path_;
  size_ += bytes.size();
  buffer_.append(bytes.data(), bytes.size());
  return buffer_.size() < kBufferSize ? absl::OkStatus() : Flush();
}

absl::Status AtomicFile::Seal() {
  RETURN_IF_ERROR(Flush());
  if (::fsync(descriptor_) != 0) return Fail("write to the disk", errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) return Fail("close", errno);
  return absl::OkStatus();
}

absl::Status AtomicFile::Commit() {
  RETURN_IF_ERROR(status_);
  CHECK_GE(descriptor_, 0) << "committed twice: " << path_;
  RETURN_IF_ERROR(Seal());
  if (set_ == nullptr) return Publish();
  set_->files_.push_back(std::move(*this));
  return status_ = absl::OkStatus();  // of what is left behind
}

absl::Status AtomicFile::Flush() {
  const char* next = buffer_.data();
  size_t remaining = buffer_.size();
  while (remaining > 0) {
    const ssize_t written = ::write(descriptor_, next, remaining);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return Fail("write", errno);
    next += written;
    remaining -= static_cast<size_t>(written);
  }
  buffer_.clear();
  return absl::OkStatus();
}

absl::Status AtomicFile::Publish() {
  if (const int error = RenameToTarget(); error != 0) return Fail("rename", error);
  const int error = SyncDirectory(DirectoryOf(target_));
  if (error == 0) return absl::OkStatus();
  const absl::Status unsynced = SystemError(path_, "write its directory to the disk", error);
  return status_ = absl::Status(
             unsynced.code(),
             absl::StrCat(unsynced.message(),
                          "; the file is whole, but may be gone again after a power cut"));
}

int AtomicFile::RenameToTarget() {
  const std::lock_guard<std::mutex> lock(TemporaryPathsMutex());
  if (::rename(temporary_path_.c_str(), target_.c_str()) != 0) return errno;
  TemporaryPaths().erase(std::exchange(temporary_path_, {}));
  return 0;
}

absl::Status AtomicFile::Fail(const char* action, int error_number) {
  Discard();
  return status_ = SystemError(path_, action, error_number);
}

void AtomicFile::Discard() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (temporary_path_.empty()) return;
  const std::lock_guard<std::mutex> lock(TemporaryPathsMutex());
  ::unlink(temporary_path_.c_str());
  TemporaryPaths().erase(std::exchange(temporary_path_, {}));
}

void AbandonAtomicFiles() {
  TemporaryPathsMutex().lock();
  for (const std::string& path : TemporaryPaths()) ::unlink(path.c_str());
}

absl::Status WriteFileAtomically(const Destination& destination, absl::string_view content) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::Create(destination));
  RETURN_IF_ERROR(file.Write(content));
  return file.Commit();
}

}  // namespace cartographer::io
