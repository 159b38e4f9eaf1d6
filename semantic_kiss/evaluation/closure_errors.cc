// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/evaluation/closure_errors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "glog/logging.h"
#include "semantic_kiss/evaluation/relative_error.h"

namespace semantic_kiss::evaluation {
namespace {

using cartographer::transform::Level;
using cartographer::transform::Rigid3d;

ClosureError ErrorInPlane(const Rigid3d& claimed, const Rigid3d& actual) {
  const double turned_rad = cartographer::transform::Yaw(claimed.rotation()) -
                            cartographer::transform::Yaw(actual.rotation());
  return {(claimed.translation() - actual.translation()).head<2>().norm(),
          std::abs(std::remainder(turned_rad, 2. * M_PI)) * 180. / M_PI};
}

ClosureError ErrorInSpace(const Rigid3d& claimed, const Rigid3d& actual) {
  const Rigid3d error = claimed.inverse() * actual;
  return {error.translation().norm(), cartographer::transform::RotationAngle(error) * 180. / M_PI};
}

// Scans by squares of the plane, so that neighbours are found without looking at all.
class Squares {
 public:
  explicit Squares(double side_m) : side_m_(side_m) {}

  void Add(int scan, const Eigen::Vector3d& position) {
    scans_[SquareOf(position)].push_back(scan);
  }
  template <typename Predicate>
  bool AnyAround(const Eigen::Vector3d& position, const Predicate& predicate) const {
    const std::pair<int, int> middle = SquareOf(position);
    for (int y = middle.second - 1; y <= middle.second + 1; ++y) {
      for (int x = middle.first - 1; x <= middle.first + 1; ++x) {
        const auto scans = scans_.find({x, y});
        if (scans != scans_.end() &&
            std::any_of(scans->second.begin(), scans->second.end(), predicate)) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  std::pair<int, int> SquareOf(const Eigen::Vector3d& position) const {
    return {static_cast<int>(std::floor(position.x() / side_m_)),
            static_cast<int>(std::floor(position.y() / side_m_))};
  }

  const double side_m_;
  std::map<std::pair<int, int>, std::vector<int>> scans_;
};

// Whether each scan is a revisit of an earlier one.
std::vector<bool> FindRevisits(const std::vector<Rigid3d>& truth,
                               const std::vector<double>& driven_m, const RevisitOptions& options) {
  std::vector<bool> revisits(truth.size(), false);
  Squares earlier(options.max_distance_m);
  size_t next = 0;
  for (size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d& position = truth[i].translation();
    for (; driven_m[i] - driven_m[next] >= options.min_travel_m && next < i; ++next) {
      earlier.Add(static_cast<int>(next), truth[next].translation());
    }
    revisits[i] = earlier.AnyAround(position, [&](int scan) {
      return (truth[scan].translation() - position).norm() <= options.max_distance_m;
    });
  }
  return revisits;
}

}  // namespace

std::vector<ClosureError> ClosureErrors(const std::vector<ClosureClaim>& claims,
                                        const std::vector<Rigid3d>& truth) {
  std::vector<ClosureError> errors;
  for (const ClosureClaim& claim : claims) {
    CHECK(claim.earlier >= 0 && claim.earlier < static_cast<int>(truth.size()));
    CHECK(claim.revisit >= 0 && claim.revisit < static_cast<int>(truth.size()));
    const Rigid3d& earlier = truth[claim.earlier];
    const Rigid3d& revisit = truth[claim.revisit];
    errors.push_back(
        claim.in_plane
            ? ErrorInPlane(claim.earlier_from_revisit, Level(earlier).inverse() * revisit)
            : ErrorInSpace(claim.earlier_from_revisit, earlier.inverse() * revisit));
  }
  return errors;
}

RevisitCoverage ComputeRevisitCoverage(const std::vector<ClosureClaim>& claims,
                                       const std::vector<Rigid3d>& truth,
                                       const RevisitOptions& options) {
  const std::vector<double> driven_m = DrivenDistances(truth);
  const std::vector<bool> revisits = FindRevisits(truth, driven_m, options);
  std::vector<double> closed_at_m;
  for (const ClosureClaim& claim : claims) closed_at_m.push_back(driven_m[claim.revisit]);
  std::sort(closed_at_m.begin(), closed_at_m.end());

  RevisitCoverage coverage;
  for (size_t i = 1; i < truth.size(); ++i) {
    if (!revisits[i]) continue;
    const double step_m = driven_m[i] - driven_m[i - 1];
    coverage.revisited_m += step_m;
    const auto nearest = std::lower_bound(closed_at_m.begin(), closed_at_m.end(),
                                          driven_m[i] - options.closure_reach_m);
    if (nearest != closed_at_m.end() && *nearest <= driven_m[i] + options.closure_reach_m) {
      coverage.closed_m += step_m;
    }
  }
  return coverage;
}

}  // namespace semantic_kiss::evaluation
