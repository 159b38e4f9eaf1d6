// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_IO_ATOMIC_FILE_H_
#define CARTOGRAPHER_IO_ATOMIC_FILE_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/string_view.h"

namespace cartographer::io {

class AtomicFile;

// Files that belong together: what is committed into a set appears when the set itself is
// committed, one file right after the other, and only once the bytes of all are on the disk. If
// that never happens, whatever stood under their names stays.
class AtomicFileSet {
 public:
  AtomicFileSet();
  ~AtomicFileSet();
  AtomicFileSet(const AtomicFileSet&) = delete;
  AtomicFileSet& operator=(const AtomicFileSet&) = delete;

  // Gives all files their names, in the order in which they came, up to the first error.
  absl::Status Commit();

 private:
  friend class AtomicFile;
  std::vector<AtomicFile> files_;
};

// Where a file goes: to a path, by itself or as one of a set, which must outlive the writing.
struct Destination {
  Destination(const char* path) : path(path) {}                // NOLINT: paths are meant to do
  Destination(std::string path, AtomicFileSet* set = nullptr)  // NOLINT
      : path(std::move(path)), set(set) {}

  std::string path;
  AtomicFileSet* set = nullptr;
};

// A file that appears whole or not at all. Bytes go to a hidden temporary file beside the target;
// Commit() makes them durable and gives them the target's name in one step, replacing a file that
// had it. Until then, and if anything before that step fails, whatever stood under that name stays
// as it was. (If the directory cannot be made durable after it, the file is there, but the error
// says that it may be gone after a power cut.)
//
// The target may not exist yet, be a regular file, or a symbolic link to one (the file that the
// link points to is replaced); anything else, such as a directory or a device, is an error.
//
// Errors are one line that names the target and the system's reason, with
// kResourceExhausted when the disk is full. Usage:
//   ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::Create(path));
//   RETURN_IF_ERROR(file.Write(bytes));
//   return file.Commit();
class AtomicFile {
 public:
  // The directory of the path must exist.
  static absl::StatusOr<AtomicFile> Create(const Destination& destination);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  // Removes the temporary file unless it was committed.
  ~AtomicFile();

  // Appends. Bytes are buffered, so a full disk may show only in a later Write() or in Commit().
  // After an error the temporary file is gone and every further call returns that error.
  absl::Status Write(absl::string_view bytes);

  // Call at most once, last (CHECKed). A file of a set only becomes durable, and is the set's.
  absl::Status Commit();

  // Number of bytes passed to Write() so far.
  uint64_t size() const { return size_; }

 private:
  friend class AtomicFileSet;

  AtomicFile(const Destination& destination, std::string target, std::string temporary_path,
             int descriptor);
  absl::Status Flush();
  // Makes all bytes durable.
  absl::Status Seal();
  // Returns the system's error number; 0: done.
  int RenameToTarget();
  // Gives the target its name.
  absl::Status Publish();
  // Closes and removes the temporary file and remembers the error.
  absl::Status Fail(const char* action, int error_number);
  void Discard();

  std::string path_;  // as the caller named it, for messages
  AtomicFileSet* set_;
  std::string target_;          // with symbolic links resolved
  std::string temporary_path_;  // empty once there is none
  std::string buffer_;
  absl::Status status_;
  int descriptor_ = -1;
  uint64_t size_ = 0;
};

// Removes all temporary files and blocks every other thread that would make or commit one, for
// ever: the last thing before _exit() for a process that is told to end at once.
void AbandonAtomicFiles();

// The whole content at once.
absl::Status WriteFileAtomically(const Destination& destination, absl::string_view content);

}  // namespace cartographer::io

#endif  // CARTOGRAPHER_IO_ATOMIC_FILE_H_
