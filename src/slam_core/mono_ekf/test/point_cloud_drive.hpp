// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "slam_core/camera/planar_camera.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::test {

/// A camera that looks ahead from 0.65 m, with a lens.
inline PlanarCamera forwardCamera() {
  const CameraCalibration calibration{
      640, 480, "plumb_bob", 540.0, 540.0, 321.4, 238.7, {0.12, -0.25, 0.001, -0.0005, 0.0}};
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  mount.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  mount.translation() << 0.1, 0.0, 0.65;
  return {std::make_shared<const CameraModel>(calibration), mount};
}

/// A robot on a circle within points on the walls of a round room, whose images are known without
/// any image: pixels and motion have exactly the noise that is claimed, unless the pixels' is set.
class PointCloudDrive {
 public:
  static constexpr int kLap = 100;  ///< steps of once around
  static constexpr double kPixelSigma = 1.0;

  explicit PointCloudDrive(std::uint64_t seed) : camera_(forwardCamera()), random_(seed, 0) {
    for (int i = 0; i < 220; ++i) {
      const double angle = 2 * M_PI * random_.uniform(), radius = 3.5 + 1.5 * random_.uniform();
      points_.emplace_back(radius * std::cos(angle), 1.5 + radius * std::sin(angle),
                           2.2 * random_.uniform());
    }
    Q_ << 4e-6, 0, 0, 0, 1e-6, 5e-7, 0, 5e-7, 2e-5;
  }

  const PlanarCamera& camera() const { return camera_; }
  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const Pose2& truth() const { return truth_; }
  void setPixelSigma(double sigma) { pixel_sigma_ = sigma; }

  /// @param measured over true turn
  Motion move(double measured = 1.0) {
    const double turn = 2 * M_PI / kLap;
    const Pose2 step = Pose2::exp({1.5 * turn, 0.0, turn});
    truth_ = truth_ * step;
    Motion motion;
    motion.covariance = Q_;
    const Eigen::Matrix3d L = Q_.llt().matrixL();
    Eigen::Vector3d odometry = step.vector() + L * Eigen::Vector3d(normal(), normal(), normal());
    const double wrong = measured - 1.0;
    odometry.z() += wrong * step.theta();
    motion.covariance(2, 2) += wrong * wrong * step.theta();  // as a robot file would claim
    motion.increment = Pose2::fromVector(odometry);
    return motion;
  }

  struct Pixel {
    std::size_t point;
    Eigen::Vector2d pixel;
  };
  std::vector<Pixel> look() {
    std::vector<Pixel> seen;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto projection = camera_.project(truth_, points_[i] - camera_.centre(truth_));
      if (!projection) continue;
      const auto& pixel = projection->pixel;
      if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() > 639 || pixel.y() > 479) continue;
      seen.push_back({i, pixel + pixel_sigma_ * Eigen::Vector2d(normal(), normal())});
    }
    return seen;
  }

 private:
  double normal() { return random_.gaussian(); }

  PlanarCamera camera_;
  RandomStream random_;
  double pixel_sigma_ = kPixelSigma;
  std::vector<Eigen::Vector3d> points_;
  Eigen::Matrix3d Q_;
  Pose2 truth_;
};

}  // namespace slam::test
