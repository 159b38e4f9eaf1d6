// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/file_hash.h"

#include <nettle/sha2.h>

#include <fstream>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"

namespace semantic_kiss::cli {

absl::StatusOr<std::string> Sha256OfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return absl::NotFoundError(absl::StrCat(path, ": cannot be opened"));
  sha256_ctx context;
  sha256_init(&context);
  std::vector<char> buffer(size_t{1} << 20);
  do {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    sha256_update(&context, static_cast<size_t>(file.gcount()),
                  reinterpret_cast<const uint8_t*>(buffer.data()));
  } while (file);
  if (!file.eof()) return absl::DataLossError(absl::StrCat(path, ": cannot be read"));
  std::string digest(SHA256_DIGEST_SIZE, '\0');
  sha256_digest(&context, digest.size(), reinterpret_cast<uint8_t*>(digest.data()));
  return absl::BytesToHexString(digest);
}

}  // namespace semantic_kiss::cli
