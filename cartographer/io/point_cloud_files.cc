// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/point_cloud_files.h"

#include <cstdint>
#include <vector>

#include "absl/strings/str_cat.h"
#include "cartographer/common/status.h"
#include "cartographer/io/atomic_file.h"

namespace cartographer::io {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "files are little-endian");

template <typename T>
void AppendBytes(const T& value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof(value));
}

// Lines that tell what the numbers of the labels mean which occur in the cloud.
std::string LabelComments(const MapCloud& cloud, const char* prefix) {
  std::vector<bool> occurs(cloud.labels().size());
  for (size_t i = 0; i < cloud.size(); ++i) occurs[sensor::Index(cloud.At(i).label)] = true;
  std::string comments;
  for (size_t i = 0; i < occurs.size(); ++i) {
    if (!occurs[i]) continue;
    const sensor::Label label{static_cast<uint8_t>(i)};
    absl::StrAppend(&comments, prefix, "label ", cloud.labels().FileId(label), " ",
                    cloud.labels().Name(label), "\n");
  }
  return comments;
}

std::string PlyHeader(const MapCloud& cloud) {
  return absl::StrCat("ply\nformat binary_little_endian 1.0\n", LabelComments(cloud, "comment "),
                      "element vertex ", cloud.size(),
                      "\nproperty float x\nproperty float y\nproperty float z\n"
                      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                      "property ushort label\nproperty float certainty\n",
                      cloud.has_intensities() ? "property float intensity\n" : "", "end_header\n");
}

std::string PcdHeader(const MapCloud& cloud) {
  const bool intensities = cloud.has_intensities();
  return absl::StrCat(
      "# .PCD v0.7 - Point Cloud Data file format\n", LabelComments(cloud, "# "),
      "VERSION 0.7\nFIELDS x y z rgb label certainty", intensities ? " intensity" : "",
      "\nSIZE 4 4 4 4 4 4", intensities ? " 4" : "", "\nTYPE F F F F U F", intensities ? " F" : "",
      "\nCOUNT 1 1 1 1 1 1", intensities ? " 1" : "", "\nWIDTH ", cloud.size(),
      "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS ", cloud.size(), "\nDATA binary\n");
}

void AppendPlyAttributes(sensor::Color color, uint16_t label_id, std::string* bytes) {
  for (const uint8_t component : {color.red, color.green, color.blue}) {
    AppendBytes(component, bytes);
  }
  AppendBytes(label_id, bytes);
}

void AppendPcdAttributes(sensor::Color color, uint16_t label_id, std::string* bytes) {
  AppendBytes(uint32_t{color.red} << 16 | uint32_t{color.green} << 8 | color.blue, bytes);
  AppendBytes(uint32_t{label_id}, bytes);
}

// The header, then all points; append_attributes(color, label_id, bytes) adds what formats differ
// in.
template <typename AppendAttributes>
absl::Status WritePoints(const MapCloud& cloud, const std::string& header,
                         const AppendAttributes& append_attributes, const std::string& path) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::Create(path));
  RETURN_IF_ERROR(file.Write(header));
  std::string bytes;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const MapPoint point = cloud.At(i);
    bytes.clear();
    for (const float coordinate : point.position) AppendBytes(coordinate, &bytes);
    append_attributes(cloud.labels().ColorOf(point.label), cloud.labels().FileId(point.label),
                      &bytes);
    AppendBytes(point.certainty, &bytes);
    if (cloud.has_intensities()) AppendBytes(point.intensity, &bytes);
    RETURN_IF_ERROR(file.Write(bytes));
  }
  return file.Commit();
}

}  // namespace

absl::Status WritePly(const MapCloud& cloud, const std::string& path) {
  return WritePoints(cloud, PlyHeader(cloud), &AppendPlyAttributes, path);
}

absl::Status WritePcd(const MapCloud& cloud, const std::string& path) {
  return WritePoints(cloud, PcdHeader(cloud), &AppendPcdAttributes, path);
}

}  // namespace cartographer::io
