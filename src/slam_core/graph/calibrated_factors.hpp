// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/models/calibration.hpp"

// Factors that depend on parameters of wheels and sensor as well (Kuemmerle, Grisetti, Burgard
// 2011). The parameters are variables of the graph, two of them in the place of a point, since
// their corrections are added as those of a point are.

namespace slam::graph {

/// A motion as a function of the wheels' parameters (kWheelScale, kWheelBase, kWheelDrift), linear
/// around those at which it was evaluated.
struct WheelMotion {
  Pose2 increment;                               ///< at those parameters
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();   ///< of its (x, y, theta) by the parameters
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< the parameters

  /// The motion with other parameters.
  Pose2 with(const Eigen::Vector3d& parameters) const;
  /// Other parameters multiply an error (x, y, theta) of what the wheels measured. @return the
  /// factors
  Eigen::Vector3d growth(const Eigen::Vector3d& parameters) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(increment, J, at);
  }
};

/// What is known of the parameters before the drive, or elsewhere: r = W (c - c_known).
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

/// The motion by wheels from a to b: r = W S(c) (u(c)^-1 a^-1 b), u the motion with the parameters
/// c, and S(c) the inverse of how it makes errors of the wheels grow: without it a smaller scale
/// would fit noise better.
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
  /// What the sensor's parameters were when the observation was corrected by them.
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
  /// (kRangeScale, kTimeOffset) where the scale of ranges is not known
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

/// The keys of the parameters among those of such a factor of two other variables.
inline std::vector<Key> parametersOf(const std::vector<Key>& keys) {
  return {keys.begin() + 2, keys.end()};
}

}  // namespace slam::graph
