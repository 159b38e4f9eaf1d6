// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_PLACE_CHANNELS_H_
#define CARTOGRAPHER_POSE_GRAPH_PLACE_CHANNELS_H_

#include <array>
#include <vector>

#include "absl/status/statusor.h"
#include "cartographer/pose_graph/proto/place_recognition_options.pb.h"
#include "cartographer/sensor/label.h"
#include "cartographer/sensor/label_set.h"

namespace cartographer::pose_graph {

// What the description of a place tells apart: the options' groups, compiled for a label set. An
// immutable value.
class PlaceChannels {
 public:
  static constexpr int kNotUsed = -1;

  struct Channel {
    float weight;           // > 0
    float saturation_hits;  // points per m^2 from which on a cell is full
  };

  // Labels belong to groups as in scan_matching::ScoreModel, whose errors these are.
  static absl::StatusOr<PlaceChannels> Create(const proto::PlaceRecognitionOptions& options,
                                              const sensor::LabelSet& labels);

  int size() const { return static_cast<int>(channels_.size()); }
  const Channel& operator[](int channel) const { return channels_[channel]; }
  // kNotUsed for labels of weight 0 and those of no group.
  int ChannelOf(sensor::Label label) const { return channel_of_label_[sensor::Index(label)]; }

 private:
  PlaceChannels() = default;

  std::array<int, sensor::kMaxLabels> channel_of_label_{};
  std::vector<Channel> channels_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_PLACE_CHANNELS_H_
