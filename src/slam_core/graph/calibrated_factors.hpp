// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/models/calibration.hpp"

// Factors that also depend on parameters of wheels and sensor (Kuemmerle, Grisetti, Burgard 2011).
// The parameters are variables of the graph. Two of them are stored as one point, since their
// corrections are added like those of a point.

namespace slam::graph {

/// A motion as a function of the wheels' parameters (kWheelScale, kWheelBase, kWheelDrift),
/// linearised at those with which it was evaluated.
struct WheelMotion {
  Pose2 increment;                               ///< at those parameters
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();   ///< of its (x, y, theta) by the parameters
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< the parameters

  /// The motion with other parameters.
  Pose2 with(const Eigen::Vector3d& parameters) const;
  /// @return the factors by which other parameters multiply an error (x, y, theta) of what the
  /// wheels measured
  Eigen::Vector3d growth(const Eigen::Vector3d& parameters) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(increment, J, at);
  }
};

/// What is known of the parameters from before the drive, or from another source: r = W (c -
/// c_known).
class ParameterPrior final : public Factor {
 public:
  ParameterPrior(std::vector<Key> keys, const Eigen::VectorXd& known, const Eigen::MatrixXd& W);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const Eigen::VectorXd& known() const { return known_; }
  const Eigen::MatrixXd& weight() const { return W_; }

 private:
  Eigen::VectorXd known_;
  Eigen::MatrixXd W_;
};

/// The motion from a to b as measured by wheels: r = W S(c) (u(c)^-1 a^-1 b). Here u is the motion
/// with the parameters c, and S(c) is the inverse of the factors by which c multiplies errors of
/// the wheels: without it a smaller scale would fit noise better.
class CalibratedBetween final : public Factor {
 public:
  /// @param parameters the keys of (kWheelScale, kWheelBase) and (kWheelDrift, kSensorYaw)
  /// @param W at the parameters at which the motion was evaluated
  CalibratedBetween(Key a, Key b, const std::vector<Key>& parameters, const WheelMotion& motion,
                    const Eigen::Matrix3d& W);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const WheelMotion& motion() const { return motion_; }
  const Eigen::Matrix3d& weight() const { return W_; }
  /// The same without parameters. @param at its variables, in the order of the keys
  Between with(const std::vector<Pose2>& at) const;

 private:
  WheelMotion motion_;
  Eigen::Matrix3d W_;
};

/// An observation of range and bearing whose sensor's pose and scale are not known exactly.
class CalibratedSighting final : public Factor {
 public:
  /// The sensor's parameters with which the observation was corrected.
  struct At {
    double yaw = 0.0;                                  ///< kSensorYaw [rad]
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();  ///< kSensorX, kSensorY [m]
    double range_scale = 0.0;                          ///< kRangeScale

    template <class Archive>
    void persist(Archive& archive) {
      archive(yaw, offset, range_scale);
    }
  };
  /// @param parameters the keys of (kWheelDrift, kSensorYaw) and (kSensorX, kSensorY), and that of
  /// (kRangeScale, kTimeOffset) if the scale of ranges is not known
  /// @param seen the observation, corrected by the parameters `then`
  CalibratedSighting(Key pose, Key point, const std::vector<Key>& parameters,
                     const RangeBearing& seen, const At& then);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  const RangeBearing& seen() const { return seen_; }
  const At& then() const { return then_; }
  /// The same without parameters. @param at its variables, in the order of the keys
  RangeBearing with(const std::vector<Pose2>& at) const;

 private:
  RangeBearing seen_;
  At then_;
};

/// The keys of the parameters, among the keys of such a factor that joins two other variables.
inline std::vector<Key> parametersOf(const std::vector<Key>& keys) {
  return {keys.begin() + 2, keys.end()};
}

}  // namespace slam::graph
