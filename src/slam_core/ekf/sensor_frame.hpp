// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/calibration.hpp"
#include "slam_core/models/landmark_map.hpp"

// Symbols: c the calibrated parameters, D(c) the pose of the sensor on the robot at the time of the
// observations, U(c) a motion of the robot, s the logarithm of the ranges' scale.

namespace slam::ekf {

/// The coordinates in which a filter estimates while parameters are calibrated: its robot is the
/// sensor that made the newest observations, at their time, and its unit of length is that of the
/// ranges. What is observed then does not depend on the parameters. They enter with the motion
/// alone, exp(-s) D^-1 U D: so a map that turns or shrinks as a whole when a parameter is corrected
/// tells the filter nothing that it cannot know, as it would where observations are linearised at
/// one parameter after the other.
class SensorFrame {
 public:
  /// A sensor as observations bring it.
  struct View {
    Pose2 mount;                                         ///< T_base_sensor without the parameters
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< of the robot [m/s, rad/s]

    template <class Archive>
    void persist(Archive& archive) {
      archive(mount, velocity);
    }
  };
  /// A motion of the filter's robot, and its Jacobian by the parameters.
  struct Transition {
    Pose2 increment;
    Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();
    CalibrationJacobian<3> J;
  };
  /// A Gaussian over the filter's robot and the parameters.
  struct Joint {
    Pose2 robot;
    CalibrationVector c;
    Eigen::Matrix<double, 3 + kCalibrationRows, 3 + kCalibrationRows> covariance;
  };

  /// The robot has moved.
  /// @param U with its covariance and its Jacobian by the parameters
  Transition moved(const Transition& U, const CalibrationVector& c) const;
  /// The next observations are of this sensor, of which the filter's robot becomes the pose.
  Transition look(const View& view, const CalibrationVector& c);
  /// The filter's robot becomes the robot itself; to be called where the filter is put somewhere.
  void forget() { view_.reset(); }

  /// The pose of the robot itself [m].
  PoseEstimate robot(const Joint& joint) const;
  /// The same of a map.
  /// @param map in the filter's coordinates; its joint covariance is of (robot, c, landmarks)
  MapState map(const MapState& map, const CalibrationVector& c) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(view_);
  }

 private:
  using Jacobian = Eigen::Matrix<double, 3, 3 + kCalibrationRows>;
  Pose2 robot(const Pose2& of_filter, const CalibrationVector& c, Jacobian& J) const;
  Transition between(const std::optional<View>& from, const Transition& U,
                     const std::optional<View>& to, const CalibrationVector& c) const;

  std::optional<View> view_;  ///< nothing: the filter's robot is the robot itself
};

/// A pose that is known in metres depends on the ranges' scale in their unit: a transition on the
/// spot that adds this.
SensorFrame::Transition fromMetres(const Pose2& in_range_units);
/// A pose [m] in the unit of the ranges.
PoseEstimate inRangeUnits(PoseEstimate estimate, const CalibrationVector& c);

}  // namespace slam::ekf
