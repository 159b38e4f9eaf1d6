// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef CARTOGRAPHER_POSE_GRAPH_BEARING_TRANSFORM_H_
#define CARTOGRAPHER_POSE_GRAPH_BEARING_TRANSFORM_H_

#include <Eigen/Core>
#include <vector>

namespace cartographer::pose_graph {

// Rows of values at evenly spaced bearings, by the first Fourier coefficients of every row. The
// mean of a row is left out: it says nothing about the heading. Harmonics are stored four at a
// time, those of all rows after each other, the last ones filled up with zeros.
struct BearingSpectrum {
  struct Harmonics {
    Eigen::Array4f real, imaginary;
  };
  std::vector<Harmonics> harmonics;  // of row r: [block of four * num_rows + r]
};

// Turns rows of values into spectra and compares these at all headings at once: turning the values
// by an angle multiplies coefficient k by exp(-i k angle). An immutable value.
class BearingTransform {
 public:
  static constexpr int kMaxHarmonics = 64;

  // How well two spectra agree when the first is turned by `yaw_rad`, in (-pi, pi]: the sum over
  // the rows of their products, which is at most the product of their norms.
  struct Agreement {
    double yaw_rad = 0.;
    double score = 0.;
  };

  // Keeps harmonics 1, ..., num_harmonics, of which there are at most kMaxHarmonics (CHECKed).
  explicit BearingTransform(int num_harmonics);

  // Values that a row must have; value i belongs to the bearing 2 pi i / num_bearings().
  int num_bearings() const { return num_bearings_; }

  // One row of `values` for each row of the result.
  BearingSpectrum Transform(
      const Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& values) const;

  // The heading at which `query`, turned by it, agrees best with `target`. The score is the best of
  // 8 num_harmonics headings (the first one on ties); the heading is refined by a parabola. Both
  // must have the same number of rows.
  Agreement FindBestHeading(const BearingSpectrum& query, const BearingSpectrum& target) const;

 private:
  // Harmonics of sum over the rows of target * conj(query).
  struct Product {
    alignas(16) float real[kMaxHarmonics], imaginary[kMaxHarmonics];
  };
  Product Multiply(const BearingSpectrum& query, const BearingSpectrum& target) const;

  int num_harmonics_;
  int num_bearings_;
  int num_headings_;
  // Of k * angle, for the harmonics k = 1, ... (rows) and the bearings or the headings in the first
  // quarter of a turn, both ends included (columns).
  using Table = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Table bearing_cosines_, bearing_sines_;
  Table heading_cosines_, heading_sines_;
};

}  // namespace cartographer::pose_graph

#endif  // CARTOGRAPHER_POSE_GRAPH_BEARING_TRANSFORM_H_
