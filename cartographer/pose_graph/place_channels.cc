// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/pose_graph/place_channels.h"

#include "cartographer/common/status.h"
#include "cartographer/scan_matching/score_model.h"

namespace cartographer::pose_graph {

using scan_matching::ScoreModel;

absl::StatusOr<PlaceChannels> PlaceChannels::Create(const proto::PlaceRecognitionOptions& options,
                                                    const sensor::LabelSet& labels) {
  scan_matching::proto::ScoreOptions score;
  *score.mutable_groups() = options.groups();
  ASSIGN_OR_RETURN(const ScoreModel model, ScoreModel::Create(score, labels));
  PlaceChannels result;
  result.channel_of_label_.fill(kNotUsed);
  result.channels_.resize(model.num_groups());
  for (size_t i = 0; i < labels.size(); ++i) {
    const sensor::Label label{static_cast<uint8_t>(i)};
    const int layer = model.LayerOf(label);
    if (layer == ScoreModel::kNotMatched) continue;
    const int channel = model.GroupOf(layer);
    result.channel_of_label_[i] = channel;
    result.channels_[channel] = {
        static_cast<float>(model.WeightOf(label)) / ScoreModel::kWeightSteps,
        static_cast<float>(model.SaturationOf(layer))};
  }
  return result;
}

}  // namespace cartographer::pose_graph
