// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/scan_matching/probability_surface.h"

namespace cartographer::scan_matching {
namespace {

// What the four cells around a place contribute, `t` in [0, 1) between the second and the third,
// and the derivatives.
struct CatmullRom {
  explicit CatmullRom(double t) {
    const double t2 = t * t, t3 = t2 * t;
    value << -t3 + 2. * t2 - t, 3. * t3 - 5. * t2 + 2., -3. * t3 + 4. * t2 + t, t3 - t2;
    slope << -3. * t2 + 4. * t - 1., 9. * t2 - 10. * t, -9. * t2 + 8. * t + 1., 3. * t2 - 2. * t;
    value /= 2.;
    slope /= 2.;
  }
  Eigen::Vector4d value, slope;
};

}  // namespace

ProbabilitySurface::Sample ProbabilitySurface::At(const Eigen::Vector2d& position) const {
  // In cells, counted from their centres.
  const Eigen::Array2d place = position.array() / grid_.resolution_m() - 0.5;
  const Eigen::Array2d base = place.floor();
  const CatmullRom x(place.x() - base.x()), y(place.y() - base.y());
  const submap::CellIndex corner = base.cast<int>() - 1;
  Sample sample{0., Eigen::Vector2d::Zero()};
  for (int row = 0; row < 4; ++row) {
    double along_row = 0., slope_of_row = 0.;
    grid_.ForRow({corner.x(), corner.y() + row}, 4, [&](int column, float probability) {
      along_row += x.value[column] * probability;
      slope_of_row += x.slope[column] * probability;
    });
    sample.value += y.value[row] * along_row;
    sample.gradient.x() += y.value[row] * slope_of_row;
    sample.gradient.y() += y.slope[row] * along_row;
  }
  sample.gradient /= grid_.resolution_m();
  return sample;
}

}  // namespace cartographer::scan_matching
