// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/parse_message.h"

#include <cstdint>

#include "absl/strings/str_cat.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/io/coded_stream.h"
#include "google/protobuf/stubs/logging.h"
#include "google/protobuf/wire_format_lite.h"

namespace cartographer::io {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;

// About what protobuf takes for a field that is a message, a string or unknown, beside its bytes.
constexpr int64_t kObjectBytes = 48;
constexpr int64_t kAllowedRatio = 8;
constexpr int64_t kAllowedSlack = int64_t{1} << 20;

// Walks a serialized message, one field after the other, and takes the memory of its objects from
// a budget.
class MemoryBudget {
 public:
  explicit MemoryBudget(int64_t bytes) : remaining_(bytes) {}

  // False if the message is malformed or the budget spent.
  bool Spend(CodedInputStream* input, const Descriptor* descriptor) {
    while (const uint32_t tag = input->ReadTag()) {
      const FieldDescriptor* field =
          descriptor->FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
      if (!SpendField(input, tag, field)) return false;
    }
    return input->ConsumedEntireMessage();
  }

  bool Spent() const { return remaining_ < 0; }

 private:
  bool SpendField(CodedInputStream* input, uint32_t tag, const FieldDescriptor* field) {
    // None of our messages has groups, and within an unknown one objects would go uncounted.
    if (WireFormatLite::GetTagWireType(tag) == WireFormatLite::WIRETYPE_START_GROUP) return false;
    const bool delimited =
        WireFormatLite::GetTagWireType(tag) == WireFormatLite::WIRETYPE_LENGTH_DELIMITED;
    const bool packed = delimited && field != nullptr && field->is_packable();
    if (!packed && (delimited || field == nullptr)) remaining_ -= kObjectBytes;
    if (Spent()) return false;
    if (!delimited || field == nullptr || field->message_type() == nullptr) {
      return WireFormatLite::SkipField(input, tag);
    }
    uint32_t size = 0;
    if (!input->ReadVarint32(&size) || size > INT32_MAX) return false;
    const CodedInputStream::Limit limit = input->PushLimit(static_cast<int>(size));
    if (!Spend(input, field->message_type()) || input->BytesUntilLimit() != 0) return false;
    input->PopLimit(limit);
    return true;
  }

  int64_t remaining_;
};

}  // namespace

absl::Status ParseMessage(const std::string& bytes, google::protobuf::Message* message) {
  // What is wrong with a file is said once, in the status.
  const google::protobuf::LogSilencer silencer;
  const auto size = static_cast<int>(bytes.size());
  CodedInputStream input(reinterpret_cast<const uint8_t*>(bytes.data()), size);
  MemoryBudget budget(kAllowedRatio * size + kAllowedSlack);
  const bool walked = budget.Spend(&input, message->GetDescriptor());
  if (budget.Spent()) {
    return absl::DataLossError(
        absl::StrCat("holds too many empty messages for its ", size, " bytes"));
  }
  if (walked && message->ParseFromString(bytes)) return absl::OkStatus();
  return absl::DataLossError(
      absl::StrCat("is no message of type ", message->GetDescriptor()->full_name()));
}

}  // namespace cartographer::io
