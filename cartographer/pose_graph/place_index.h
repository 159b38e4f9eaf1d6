// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_PLACE_INDEX_H_
#define CARTOGRAPHER_POSE_GRAPH_PLACE_INDEX_H_

#include <functional>
#include <map>
#include <vector>

#include "cartographer/pose_graph/bearing_transform.h"
#include "cartographer/pose_graph/place_descriptor.h"
#include "cartographer/scan_matching/planar_pose.h"
#include "cartographer/submap/id.h"

namespace cartographer::pose_graph {

// A submap that may show the place that was asked for.
struct PlaceCandidate {
  submap::SubmapId submap_id;
  // Where the query's frame then stands in the submap's; rough.
  scan_matching::PlanarPose submap_from_query;
  // In (0, 1]; 1: the places agree in all.
  double score;
};

// The places of all finished submaps, to be searched without any idea of where one is.
class PlaceIndex {
 public:
  // Descriptors must all come from this describer or one of the same options and label set.
  explicit PlaceIndex(const PlaceDescriber& describer) : describer_(describer) {}

  // Replaces what was known of the submap. Only the view from the centre is kept. An empty
  // descriptor is never found.
  void Add(const submap::SubmapId& id, const PlaceDescriptor& descriptor);
  // Does nothing if the submap is not in the index.
  void Remove(const submap::SubmapId& id);
  size_t size() const { return places_.size(); }

  // The submaps that agree best with the query, at most `max_candidates`, among those that
  // `allowed` lets in (called once for each, in ascending order, by the calling thread); an empty
  // function allows all. None for an empty query.
  //
  // Every allowed place is compared, in parallel, with the query as seen from its coarser grid of
  // points, at all headings. Those that agree best are compared once more, from all points, which
  // gives their poses and scores; they are returned best first. Ties go to the smaller id.
  std::vector<PlaceCandidate> Find(
      const PlaceDescriptor& query, int max_candidates,
      const std::function<bool(const submap::SubmapId&)>& allowed) const;

 private:
  struct Place {
    Eigen::Vector2d center;
    BearingSpectrum view;
  };

  // The best score over the query's views of the coarser grid.
  double CoarseScore(const PlaceDescriptor& query, const Place& place) const;
  // From all views.
  PlaceCandidate Compare(const PlaceDescriptor& query, const submap::SubmapId& id,
                         const Place& place) const;

  PlaceDescriber describer_;
  std::map<submap::SubmapId, Place> places_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_PLACE_INDEX_H_
