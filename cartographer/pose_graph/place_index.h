// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_PLACE_INDEX_H_
#define CARTOGRAPHER_POSE_GRAPH_PLACE_INDEX_H_

#include <functional>
#include <map>
#include <vector>

#include "cartographer/pose_graph/place_descriptor.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/submap/id.h"

namespace cartographer::pose_graph {

// A submap that may show the place that was asked for.
struct PlaceCandidate {
  submap::SubmapId submap_id;
  // Rough: where the query's frame then stands in the submap's.
  scan_matching::PlanarPose submap_from_query;
  double score;  // 1: the places agree in all; the higher the better
};

// The places of all finished submaps, to be searched without any idea of where one is.
class PlaceIndex {
 public:
  // Descriptors must come from describers of the same options and label set.
  explicit PlaceIndex(const PlaceDescriber& describer) : describer_(describer) {}

  // Replaces what was known of the submap. An empty descriptor is never found.
  void Add(const submap::SubmapId& id, PlaceDescriptor descriptor);
  // Does nothing if the submap is not in the index.
  void Remove(const submap::SubmapId& id);
  size_t size() const { return descriptors_.size(); }
  // nullptr if the submap is not in the index.
  const PlaceDescriptor* Find(const submap::SubmapId& id) const;

  // The submaps that agree best with the query, best first (the smaller id on ties), at most
  // `max_candidates`, among those that `allowed` lets in (called once for each, in ascending order,
  // by the calling thread); an empty function allows all. None for an empty query.
  std::vector<PlaceCandidate> Find(
      const PlaceDescriptor& query, int max_candidates,
      const std::function<bool(const submap::SubmapId&)>& allowed) const;

 private:
  PlaceDescriber describer_;
  std::map<submap::SubmapId, PlaceDescriptor> descriptors_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_PLACE_INDEX_H_
