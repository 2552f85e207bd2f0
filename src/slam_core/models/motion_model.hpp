// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// How uncertain an odometry increment is. The increment itself is always the exact SE(2) one, so
/// that it serves differential and omnidirectional robots alike.
class MotionModel {
 public:
  virtual ~MotionModel() = default;
  /// Of (x, y, theta) of the increment [m^2, m rad, rad^2]; symmetric, positive semidefinite.
  virtual Eigen::Matrix3d covariance(const Pose2& increment) const = 0;
};

struct OdometryNoise {
  double alpha1 = 0.0;           ///< translation -> translation variance
  double alpha2 = 0.0;           ///< rotation -> translation variance
  double alpha3 = 0.0;           ///< translation -> rotation variance
  double alpha4 = 0.0;           ///< rotation -> rotation variance
  bool omnidirectional = false;  ///< slips across its way as much as along it
  double alpha5 = 0.0;           ///< translation -> final rotation variance; velocity model only
  double alpha6 = 0.0;           ///< rotation -> final rotation variance; velocity model only
};

/// Eq. 5.1-5.2: the robot turns, then drives. The variances alpha1 d^2 + alpha2 r^2 and
/// alpha3 d^2 + alpha4 r^2 are quadratic in the increment (alphas [1], [m^2/rad^2], [rad^2/m^2],
/// [1]), so that the same way cut into more increments comes out as less uncertain.
class QuadraticMotionModel final : public MotionModel {
 public:
  explicit QuadraticMotionModel(const OdometryNoise& noise) : noise_(noise) {}
  Eigen::Matrix3d covariance(const Pose2& increment) const override;

 private:
  OdometryNoise noise_;
};

/// Variances grow with the way and the angle turned, alpha1 d + alpha2 |r| and alpha3 d + alpha4
/// |r| (alphas [m^2/m], [m^2/rad], [rad^2/m], [rad^2/rad]), as white noise spread evenly over the
/// arc does: the sum over a way does not depend on how often odometry arrives.
class LinearMotionModel final : public MotionModel {
 public:
  explicit LinearMotionModel(const OdometryNoise& noise) : noise_(noise) {}
  Eigen::Matrix3d covariance(const Pose2& increment) const override;

 private:
  OdometryNoise noise_;
};

/// The velocity model (thesis 3.4.3; Thrun, Burgard, Fox 2005, ch. 5.3, table 5.3): speed and turn
/// rate held over the interval have errors of variance alpha1 v^2 + alpha2 w^2 and alpha3 v^2 +
/// alpha4 w^2, which bend the arc, and a final rotation of variance alpha5 v^2 + alpha6 w^2 lets
/// the heading leave it. With v = d / dt and w = r / dt the interval cancels out: of an increment
/// they are quadratic in its way d and its angle r (alphas [1], [m^2/rad^2], [rad^2/m^2], [1],
/// [rad^2/m^2], [1]), as QuadraticMotionModel's are, and depend on the rate of odometry likewise.
class VelocityMotionModel final : public MotionModel {
 public:
  explicit VelocityMotionModel(const OdometryNoise& noise) : noise_(noise) {}
  Eigen::Matrix3d covariance(const Pose2& increment) const override;

 private:
  OdometryNoise noise_;
};

/// The names makeMotionModel() knows.
const std::vector<std::string>& motionModelNames();

/// `name` is one of motionModelNames().
std::unique_ptr<MotionModel> makeMotionModel(const std::string& name, const OdometryNoise& noise);

}  // namespace slam
