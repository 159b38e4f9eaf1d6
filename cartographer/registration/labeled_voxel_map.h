// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_REGISTRATION_LABELED_VOXEL_MAP_H_
#define CARTOGRAPHER_REGISTRATION_LABELED_VOXEL_MAP_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "cartographer/registration/proto/registration_options.pb.h"
#include "cartographer/registration/voxel_index.h"
#include "cartographer/sensor/labeled_point_cloud.h"
#include "cartographer/transform/rigid_transform.h"

namespace cartographer::registration {

// A sparse set of labeled points with fast nearest-neighbour search: the odometry's local map, a
// submap's cloud.
//
// Space is cut into voxels. A voxel takes at most `max_points_per_voxel` points, none closer than
// voxel_size / sqrt(max_points_per_voxel) to another one, and up to
// `max_critical_points_per_voxel` points of critical classes beyond that, however close: poles and
// signs are few and hold the map in place (the paper, section on sub-sampling). Options for the
// baseline SAGE-ICP let points crowd and labeled points displace unlabeled ones.
//
// Points are stored as float offsets from their voxel's corner, so that they keep their precision
// kilometres away from the origin. The result depends on the order of insertions alone.
class LabeledVoxelMap {
 public:
  struct Neighbor {
    Eigen::Vector3d position;
    sensor::Label label;
  };
  struct Nearest {
    std::optional<Neighbor> neighbor;
    // No other point that was looked for is nearer than this [m]: what tells how far the query may
    // move before the answer can change.
    float others_beyond_m;
  };

  // Classes in `critical` are spared by the voxel's limit.
  LabeledVoxelMap(const proto::VoxelMapOptions& options, const sensor::LabelMask& critical);

  // Adds what the limits let in. Positions must be finite.
  void Insert(const sensor::LabeledPointCloud& cloud, const transform::Rigid3d& map_from_cloud);

  // Drops the voxels whose first point is `distance_m` or farther from `center`.
  void RemoveFarFrom(const Eigen::Vector3d& center, double distance_m);

  void Clear();

  // The point nearest to `query` among those nearer than `max_distance_m` in the 27 voxels
  // around it (so distances over voxel_size_m are not all seen), if there is one.
  Nearest FindNearest(const Eigen::Vector3d& query, double max_distance_m) const;

  // The point of the 27 voxels whose squared distance from `query` is the smallest after points
  // whose label agrees with `label` (all, if that is kUnlabeled) and unlabeled points had theirs
  // multiplied by `agreeing_factor` in (0, 1]. However far it is; `others_beyond_m` is in the same
  // weighted measure. Source: SAGE-ICP, semantic-aided association.
  Nearest FindPreferred(const Eigen::Vector3d& query, sensor::Label label,
                        double agreeing_factor) const;

  // The voxel that a point lies in.
  VoxelCoordinates VoxelAt(const Eigen::Vector3d& point) const {
    return VoxelOf(point, inverse_voxel_size_);
  }

  // All points, voxel by voxel.
  sensor::LabeledPointCloud ToPointCloud() const;

  bool Empty() const { return voxels_.empty(); }
  size_t num_voxels() const { return voxels_.size(); }
  size_t num_points() const { return num_points_; }

 private:
  // Points live in blocks of `block_capacity_` slots: all x, then all y, then all z. A voxel has
  // one block and, where critical points overflow it, further ones in a chain.
  struct Voxel {
    VoxelCoordinates coordinates;
    uint32_t first_block;
    uint16_t num_ordinary = 0;
    uint16_t num_critical = 0;
  };
  struct Block {
    uint32_t next = VoxelIndex::kNone;
    uint16_t size = 0;
  };
  struct Search;

  void InsertPoint(const Eigen::Vector3d& point, sensor::Label label, float certainty);
  bool HasRoom(const Voxel& voxel, const Eigen::Vector3f& offset, bool critical) const;
  void Append(Voxel* voxel, const Eigen::Vector3f& offset, sensor::Label label, float certainty);
  // Puts a labeled point in an unlabeled one's place.
  void Displace(const Voxel& voxel, const Eigen::Vector3f& offset, sensor::Label label,
                float certainty);
  void Store(uint32_t block, uint32_t slot, const Eigen::Vector3f& offset, sensor::Label label,
             float certainty);
  // Both searches; a Measure weighs the squared distances of points by their labels.
  template <typename Measure>
  Nearest FindBy(const Measure& measure, const Eigen::Vector3d& query, double max_distance_m) const;
  template <typename Measure>
  void SearchVoxel(const Measure& measure, const VoxelCoordinates& voxel,
                   const Eigen::Vector3f& query_offset, Search* search) const;
  uint32_t NewBlock();
  void FreeBlocks(uint32_t first_block);
  float* Coordinates(uint32_t block) { return &coordinates_[3 * size_t{block} * block_capacity_]; }
  const float* Coordinates(uint32_t block) const {
    return &coordinates_[3 * size_t{block} * block_capacity_];
  }
  Eigen::Vector3d Corner(const VoxelCoordinates& voxel) const {
    return voxel.cast<double>().matrix() * voxel_size_;
  }

  const double voxel_size_;
  const double inverse_voxel_size_;
  const int max_ordinary_;
  const int max_critical_;
  const float min_squared_distance_;  // 0: points may crowd
  const bool displace_unlabeled_;
  const uint32_t block_capacity_;
  const sensor::LabelMask critical_;

  VoxelIndex index_;  // into voxels_
  std::vector<Voxel> voxels_;
  std::vector<Block> blocks_;
  std::vector<float> coordinates_;
  std::vector<sensor::Label> labels_;
  std::vector<float> certainties_;
  std::vector<uint32_t> free_blocks_;
  size_t num_points_ = 0;
};

}  // namespace cartographer::registration

#endif  // CARTOGRAPHER_REGISTRATION_LABELED_VOXEL_MAP_H_
