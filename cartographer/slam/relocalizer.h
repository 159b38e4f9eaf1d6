// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_SLAM_RELOCALIZER_H_
#define CARTOGRAPHER_SLAM_RELOCALIZER_H_

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/strings/string_view.h"
#include "cartographer/common/stopwatch.h"
#include "cartographer/map/map.h"
#include "cartographer/pose_graph/pose_graph.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/slam/local_trajectory_builder.h"
#include "cartographer/slam/proto/relocalization_options.pb.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::slam {

enum class LocalizationState {
  kSearching,  // somewhere, perhaps not in the map
  kLocalized,
  kLost  // the estimate was given up; what is seen from now on is gathered for the next search
};

// "searching", "localized", "lost".
absl::string_view StateName(LocalizationState state);

// What is known right after a scan.
struct LocalizedScan {
  common::Time time;
  LocalizationState state = LocalizationState::kSearching;
  // Why not localized: a word of pose_graph::NodeOutcome. Empty while localized, and before the
  // first search.
  std::string reason;
  // By what was known then, not corrected later; absent unless localized.
  std::optional<transform::Rigid3d> map_from_sensor;
  // Of the last match with the map that was accepted: the share of points that fit.
  double score = 0.;
  double since_match_m = 0.;  // the way driven since then
  std::string outcome;        // the odometry's
  std::vector<common::StageTime> stage_times;
};

// Where a drive is in a finished map, from an unknown start or a known one: its own odometry and
// submaps, tied to the map's submaps by loop closures as soon as places are recognized. The map
// does not change. What lies behind the vehicle is smoothed, then forgotten: memory is bounded.
//
// When places are no longer found where they should be, the estimate is given up, and the search
// begins anew with an odometry that knows nothing of what was before.
class Relocalizer {
 public:
  // Makes an odometry; called at the start and whenever the vehicle was lost.
  using MakeBuilder = std::function<std::unique_ptr<LocalTrajectoryBuilder>()>;

  // `pose_graph` (not null, CHECKed) is empty; its options should have it search after every node.
  // Node clouds of the map are not needed.
  Relocalizer(const proto::RelocalizationOptions& options, MakeBuilder make_builder,
              std::unique_ptr<pose_graph::PoseGraph> pose_graph, const map::Map& map);

  // The first scan will be taken about here: position [m] and heading [rad] in the map, seen from
  // above. Before the first AddScan().
  void StartNear(const Eigen::Vector2d& position, double yaw);

  // Scans must come with increasing time.
  LocalizedScan AddScan(const sensor::LabeledScan& scan);

  // One pose for each scan, map_from_sensor as it is known in the end, from what came before and
  // after; nullopt for those that no match with the map followed. No AddScan() may follow.
  std::vector<std::optional<transform::Rigid3d>> Finish();

  const pose_graph::VerdictCounts& verdicts() const { return pose_graph_->verdicts(); }

 private:
  // A scan whose place may still be corrected.
  struct Pending {
    size_t scan;
    submap::NodeId node_id;
    transform::Rigid3d node_from_sensor;
  };

  void BeginTrajectory();
  void AddNode(LocalResult* result);
  // Draws the conclusions from what a round of search found.
  void Judge();
  void NoteMatch();
  void Lose(const std::string& reason);
  // Makes the poses of scans final whose nodes are before `first_kept`.
  void Settle(const submap::NodeId& first_kept);
  void Trim();

  const proto::RelocalizationOptions options_;
  const MakeBuilder make_builder_;
  const std::unique_ptr<pose_graph::PoseGraph> pose_graph_;
  std::unique_ptr<LocalTrajectoryBuilder> builder_;

  LocalizationState state_ = LocalizationState::kSearching;
  std::string reason_;
  int trajectory_id_;
  int num_nodes_ = 0;  // of the trajectory
  int failures_ = 0;   // in a row
  double score_ = 0.;
  double driven_m_ = 0.;  // on the trajectory
  double matched_at_m_ = 0.;
  std::optional<submap::NodeId> last_match_;
  std::deque<std::pair<submap::NodeId, double>> kept_;  // nodes and the way driven up to them
  std::optional<transform::Rigid3d> local_from_last_;

  std::deque<Pending> pending_;
  std::vector<std::optional<transform::Rigid3d>> smoothed_;
};

}  // namespace cartographer::slam

#endif  // CARTOGRAPHER_SLAM_RELOCALIZER_H_
