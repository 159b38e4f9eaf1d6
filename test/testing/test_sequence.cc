// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "test/testing/test_sequence.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "cartographer/io/trajectory_files.h"
#include "glog/logging.h"
#include "test/testing/test_files.h"

namespace semantic_kiss_testing {
namespace {

using cartographer::transform::Rigid3d;

constexpr double kSensorHeight_m = 1.73;
constexpr double kRange_m = 25.;
constexpr uint32_t kCar = 10;
constexpr uint32_t kMovingCar = 252;

// The classes of the single-scan benchmark, in the order of the columns of N x C certainties.
constexpr uint32_t kColumnIds[] = {0,  10, 11, 15, 18, 20, 30, 31, 32, 40,
                                   44, 48, 49, 50, 51, 70, 71, 72, 80, 81};

struct StreetPoint {
  Eigen::Vector3d position;  // street's frame
  uint32_t id;
};

// A rectangle: origin + a * edge_a + b * edge_b, a and b in [0, 1].
struct Surface {
  Eigen::Vector3d origin, edge_a, edge_b;
  uint32_t id;
};

void AddBox(const Eigen::Vector3d& corner, const Eigen::Vector3d& size, uint32_t id,
            std::vector<Surface>* surfaces) {
  const Eigen::Vector3d x(size.x(), 0., 0.), y(0., size.y(), 0.), z(0., 0., size.z());
  surfaces->push_back({corner, x, z, id});
  surfaces->push_back({corner + y, x, z, id});
  surfaces->push_back({corner, y, z, id});
  surfaces->push_back({corner + x, y, z, id});
  surfaces->push_back({corner + z, x, y, id});
}

std::vector<Surface> StreetSurfaces() {
  constexpr double kStart_m = -30., kLength_m = 120.;
  const Eigen::Vector3d along(kLength_m, 0., 0.), across(0., 1., 0.), up(0., 0., 1.);
  const auto at = [](double x, double y, double z = 0.) {
    return Eigen::Vector3d(x, y, z - kSensorHeight_m);
  };
  std::vector<Surface> surfaces = {{at(kStart_m, -5.), along, 10. * across, 40},
                                   {at(kStart_m, -8., 0.15), along, 3. * across, 48},
                                   {at(kStart_m, 5., 0.15), along, 3. * across, 48},
                                   {at(kStart_m, -8.), along, 6. * up, 50},
                                   {at(kStart_m, 8.), along, 6. * up, 50}};
  for (double x = kStart_m; x < kStart_m + kLength_m; x += 9.) {
    AddBox(at(x, 5.5), {0.2, 0.2, 4.}, 80, &surfaces);
    AddBox(at(x + 4., -6.), {0.4, 0.4, 3.}, 71, &surfaces);
    AddBox(at(x + 2., -4.8), {4.2, 1.7, 1.5}, kCar, &surfaces);
  }
  return surfaces;
}

std::vector<StreetPoint> SamplePoints(const std::vector<Surface>& surfaces, double points_per_m2,
                                      std::mt19937* random) {
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<StreetPoint> points;
  for (const Surface& surface : surfaces) {
    const double area_m2 = surface.edge_a.cross(surface.edge_b).norm();
    const int count = std::max(1, static_cast<int>(area_m2 * points_per_m2));
    for (int i = 0; i < count; ++i) {
      const double a = uniform(*random), b = uniform(*random);
      points.push_back({surface.origin + a * surface.edge_a + b * surface.edge_b, surface.id});
    }
  }
  return points;
}

// The same points for every scan, but for the moving car.
std::vector<StreetPoint> PointsAtScan(const TestStreet& street, int index) {
  std::mt19937 random(street.seed);
  std::vector<StreetPoint> points = SamplePoints(StreetSurfaces(), street.points_per_m2, &random);
  std::vector<Surface> car;
  AddBox({6. + 1.2 * index, 2., -kSensorHeight_m}, {4.2, 1.7, 1.5}, kMovingCar, &car);
  const std::vector<StreetPoint> moving = SamplePoints(car, street.points_per_m2, &random);
  points.insert(points.end(), moving.begin(), moving.end());
  return points;
}

std::vector<float> Certainties(const RawScan& scan, TestCertainties kind) {
  constexpr float kCertainty = 0.8f;
  if (kind == TestCertainties::kPerPoint) return std::vector<float>(scan.num_points(), kCertainty);
  const size_t num_columns = std::size(kColumnIds);
  const float rest = (1.f - kCertainty) / static_cast<float>(num_columns - 1);
  std::vector<float> rows(scan.num_points() * num_columns, rest);
  for (size_t i = 0; i < scan.num_points(); ++i) {
    const uint32_t id = scan.ids[i] == kMovingCar ? kCar : scan.ids[i];
    const size_t column =
        std::find(std::begin(kColumnIds), std::end(kColumnIds), id) - std::begin(kColumnIds);
    CHECK_LT(column, num_columns) << id;
    rows[i * num_columns + column] = kCertainty;
  }
  return rows;
}

std::string CalibrationText() {
  const Eigen::Matrix<double, 3, 4> matrix = TestCameraFromLidar().Matrix();
  std::string text = "P0: 700 0 600 0 0 700 180 0 0 0 1 0\nTr:";
  for (int i = 0; i < 12; ++i) absl::StrAppendFormat(&text, " %.12e", matrix(i / 4, i % 4));
  return text + "\n";
}

void WriteScan(const std::string& sequence, const RawScan& scan, int index,
               const TestSequenceFiles& files) {
  const std::string stem = absl::StrFormat("%06d", index);
  WriteValues(absl::StrCat(sequence, "/velodyne/", stem, ".bin"), scan.rows);
  if (files.labels) WriteValues(absl::StrCat(sequence, "/labels/", stem, ".label"), scan.ids);
  if (files.certainties == TestCertainties::kNone) return;
  WriteValues(absl::StrCat(sequence, "/confidences/", stem, ".conf"),
              Certainties(scan, files.certainties));
}

}  // namespace

Rigid3d TestStreet::StreetFromSensor(int index) const {
  const Eigen::AngleAxisd turn(turn_rad, Eigen::Vector3d::UnitZ());
  const Rigid3d step({step_m, 0., 0.}, Eigen::Quaterniond(turn));
  Rigid3d pose;
  for (int i = 0; i < index; ++i) pose = pose * step;
  return pose;
}

RawScan ScanStreet(const TestStreet& street, int index) {
  const Rigid3d sensor_from_street = street.StreetFromSensor(index).inverse();
  RawScan scan;
  for (const StreetPoint& point : PointsAtScan(street, index)) {
    const Eigen::Vector3f seen = (sensor_from_street * point.position).cast<float>();
    if (seen.norm() > kRange_m) continue;
    scan.rows.insert(scan.rows.end(), {seen.x(), seen.y(), seen.z(), 0.3f});
    scan.ids.push_back(point.id);
  }
  return scan;
}

Rigid3d TestCameraFromLidar() {
  Eigen::Matrix3d rotation;  // camera: x right, y down, z forward
  rotation << 0., -1., 0., 0., 0., -1., 1., 0., 0.;
  const Eigen::AngleAxisd tilt(0.01, Eigen::Vector3d::UnitX());
  return Rigid3d({-0.01, -0.05, -0.29}, Eigen::Quaterniond(tilt.toRotationMatrix() * rotation));
}

void WriteTestSequence(const std::string& directory, const TestStreet& street,
                       const TestSequenceFiles& files) {
  const std::string sequence = absl::StrCat(directory, "/sequences/", files.sequence);
  std::string times;
  std::vector<Rigid3d> poses;
  for (int i = 0; i < street.num_scans; ++i) {
    WriteScan(sequence, ScanStreet(street, i), i, files);
    absl::StrAppendFormat(&times, "%.6e\n", 0.1 * i);
    poses.push_back(street.StreetFromSensor(i));
  }
  if (files.times) WriteText(sequence + "/times.txt", times);
  if (files.calibration) {
    WriteText(sequence + "/calib.txt", CalibrationText());
    poses = cartographer::io::PosesOfOtherBody(poses, TestCameraFromLidar());
  }
  if (!files.ground_truth) return;
  const std::string poses_file = absl::StrCat(directory, "/poses/", files.sequence, ".txt");
  WriteText(poses_file, "");  // makes the directory
  const absl::Status status = cartographer::io::WriteKittiPoses(poses_file, poses);
  CHECK(status.ok()) << status;
}

}  // namespace semantic_kiss_testing
