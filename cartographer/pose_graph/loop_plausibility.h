// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_LOOP_PLAUSIBILITY_H_
#define CARTOGRAPHER_POSE_GRAPH_LOOP_PLAUSIBILITY_H_

#include <map>
#include <vector>

#include "cartographer/pose_graph/graph_selection.h"
#include "cartographer/pose_graph/odometry_chain.h"
#include "cartographer/pose_graph/proto/optimization_options.pb.h"

namespace cartographer::pose_graph {

// Tells, in the order of the selection, which loops the odometry can be reconciled with. A robust
// kernel alone cannot: it sees what loops contradict each other, and where there is but one, the
// odometry gives way to it however far that is.
//
// A loop is plausible if its error against the odometry is at most n * loop_scale_sigmas of the
// odometry's standard deviations, where n is the number of loops that say the same: itself and
// those beside it, at most 50 m away along both visits. One measurement does not outweigh the
// odometry if that would have to be far worse than it is known to be; but it may have slipped
// somewhere, and that wrong loops agree is ever less likely the more they are. Loops between
// trajectories have no odometry against them and are plausible.
//
// `chains` has all moving trajectories. Compare Mangelson et al., "Pairwise consistent measurement
// set maximization", ICRA 2018: ours asks the neighbours only, and only if it must.
std::vector<bool> FindPlausibleLoops(const proto::OptimizationOptions& options,
                                     const GraphSelection& selection,
                                     const std::map<int, OdometryChain>& chains);

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_LOOP_PLAUSIBILITY_H_
