// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// What a robot file may have wrong about wheels and landmark sensor, as parameters that a back-end
/// can estimate beside pose and map. All are 0 where the robot file is right. The first three are
/// the systematic errors of two wheels (Borenstein and Feng 1996; Martinelli et al. 2007).
enum CalibrationParameter : Eigen::Index {
  kWheelScale,  ///< logarithm of true over measured way, and angle, of the wheels
  kWheelBase,   ///< logarithm of true over configured distance of the wheels: the angle shrinks
  kWheelDrift,  ///< the robot turns by so much more on its way, as with unequal wheels [rad/m]
  kSensorYaw,   ///< the sensor is turned by this, counter-clockwise [rad]
  kRangeScale,  ///< logarithm of true over measured range
  kSensorX,     ///< the sensor stands so much further ahead [m]
  kSensorY,     ///< the sensor stands so much further to the left [m]
  kTimeOffset   ///< observations were made so much after their stamps [s]
};
constexpr Eigen::Index kCalibrationRows = 8;

using CalibrationVector = Eigen::Matrix<double, kCalibrationRows, 1>;
/// A Jacobian in the parameters; without columns where nothing is calibrated.
template <int rows>
using CalibrationJacobian = Eigen::Matrix<double, rows, Eigen::Dynamic, 0, rows, kCalibrationRows>;

/// Parameters as they are known.
struct CalibrationEstimate {
  CalibrationVector parameters = CalibrationVector::Zero();
  Eigen::Matrix<double, kCalibrationRows, kCalibrationRows> covariance =
      Eigen::Matrix<double, kCalibrationRows, kCalibrationRows>::Zero();

  template <class Archive>
  void persist(Archive& archive) {
    archive(parameters, covariance);
  }
};

/// A parameter as people read it: a scale as true over measured.
struct CalibratedParameter {
  std::string name, unit;
  double value = 0.0, sigma = 0.0, sigma_before = 0.0;
  bool is_told = false;  ///< by the drive: the standard deviation is below 0.3 of the prior's
};

/// Which parameters are estimated, and how wrong the robot file may be: the priors. What is not
/// estimated is not known exactly either: it is taken to be right within a twentieth of its prior,
/// so that the estimates of the others are no surer than that allows. Ranges that are not estimated
/// are the unit of length, and right by definition. Stamps that are not estimated are taken to be
/// right as well: the noise of the velocity would pass for a delay.
struct CalibrationConfig {
  static constexpr const char* kSection = "calibration";

  std::vector<std::string> estimate;
  double sigma_wheel_scale = 0.2;
  double sigma_wheel_base = 0.1;
  double sigma_wheel_drift = 0.1;
  double sigma_sensor_yaw = 0.1;
  double sigma_range_scale = 0.1;
  double sigma_sensor_offset = 0.1;
  double sigma_time_offset = 0.05;

  void describe(Fields& fields);
  bool isOn() const { return !estimate.empty(); }
  bool estimates(CalibrationParameter row) const;
  /// The names of what is estimated of the wheels.
  std::vector<std::string> namesOfWheels() const;
  /// The priors.
  CalibrationEstimate prior() const;
  /// Those that are estimated.
  std::vector<CalibratedParameter> parametersOf(const CalibrationEstimate& known) const;
  /// 1 for each parameter that the drive tells, 0 for the others: for both scales where they are
  /// estimated and the drive tells their ratio only.
  CalibrationVector told(const CalibrationEstimate& known) const;
  /// @return a sentence for each estimated parameter, which says whether the drive tells it, and
  /// one where the drive does not tell the two scales apart
  std::vector<std::string> sentencesOn(const CalibrationEstimate& known) const;
  /// Empty, or that a parameter is where its prior hardly allows it to be.
  std::string faultOf(const CalibrationEstimate& known) const;

 private:
  std::vector<CalibrationParameter> estimatedRows() const;
  bool isTold(CalibrationParameter row, const CalibrationEstimate& known) const;
  bool mixesScales(const CalibrationEstimate& known) const;
};

/// A motion by wheels as it is with these parameters.
/// @param J of the increment (x, y, theta)
Pose2 calibrated(const Pose2& increment, const CalibrationVector& parameters,
                 CalibrationJacobian<3>* J = nullptr);
Motion calibrated(Motion motion, const CalibrationVector& parameters,
                  CalibrationJacobian<3>* J = nullptr);
/// An observation's range, covariance and extent as they are with these parameters.
LandmarkObservation calibrated(LandmarkObservation z, const CalibrationVector& parameters);
/// The pose of a sensor relative to the robot at the stamp of its observations.
/// @param mount as the robot file or the transforms have it
/// @param velocity of the robot in its own frame (x, y, heading) [m/s, rad/s]
/// @param J of the pose (x, y, theta)
Pose2 calibrated(const Pose2& mount, const Eigen::Vector3d& velocity,
                 const CalibrationVector& parameters, CalibrationJacobian<3>* J = nullptr);
/// All of the above of a sensor's observations.
LandmarkObservationArray calibrated(LandmarkObservationArray array, const Eigen::Vector3d& velocity,
                                    const CalibrationVector& parameters);

}  // namespace slam
