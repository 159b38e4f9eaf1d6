// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_GRADUATED_KERNEL_H_
#define CARTOGRAPHER_POSE_GRAPH_GRADUATED_KERNEL_H_

#include <vector>

namespace cartographer::pose_graph {

// The kernel through which loops pull: Geman and McClure's. With the squared error e in standard
// deviations and the squared scale s, the cost is s * e / (s + e) / 2: that of a spring where e is
// small, never over s / 2. As a least squares problem that is solved again and again, the weight of
// e is (s / (s + e))^2.
//
// It has many local minima, so it is narrowed step by step from a kernel that is so wide that all
// loops pull as springs do: in place of s stands mu * s, with mu falling to 1.
// Source: Yang et al., "Graduated non-convexity for robust spatial perception", RA-L 2020.
class GraduatedKernel {
 public:
  // `squared_scale` > 0 (CHECKed).
  explicit GraduatedKernel(double squared_scale);

  // Narrows the kernel, at the first call to the width that suits the largest of the errors.
  void Narrow(const std::vector<double>& squared_errors);
  // True once mu is 1.
  bool IsFinal() const { return mu_ == 1.; }

  double Weight(double squared_error) const;
  // With mu = 1.
  double Cost(double squared_error) const;

 private:
  const double squared_scale_;
  double mu_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_GRADUATED_KERNEL_H_
