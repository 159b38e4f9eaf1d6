// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_MAP_REMOVE_TRANSIENT_H_
#define CARTOGRAPHER_MAP_REMOVE_TRANSIENT_H_

#include "cartographer/map/filter_scope.h"
#include "cartographer/map/map.h"
#include "cartographer/map/proto/filter_options.pb.h"

namespace cartographer::map {

// Removes what was there on one visit and gone on another (transient_search.h): hits of movable and
// unlabeled labels, and the points that go with them. Where there is no ground label, or a place
// was visited once, nothing is removed.
//
// What a visit lost may have been all that spoke against calling a neighbouring cell free; so this
// is repeated until nothing goes any more, and doing it once more changes nothing. Submaps outside
// of the scope bear witness, but lose nothing.
void RemoveTransient(const FilterScope& scope, const proto::TransientOptions& options, Map* map);

}  // namespace cartographer::map

#endif  // CARTOGRAPHER_MAP_REMOVE_TRANSIENT_H_
