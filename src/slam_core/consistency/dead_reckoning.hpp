// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Dead reckoning: the path since an observation last corrected the pose. A landmark that was first
/// seen after such a path has the pose error that the robot had then: it corrects later errors, but
/// not the earlier ones.
///
/// An odometry source takes the errors of its increments to be independent. Over a metre this is
/// acceptable, with a variance that covers the error of wheels of slightly wrong sizes. But such an
/// error is the same in each piece, so that over longer paths it grows with the length of the path
/// instead of its square root. So beyond a metre the errors are taken to be correlated as much as
/// possible. For an error x of the path so far, of covariance P, and an error y of a further step,
/// of covariance Q, correlated in any way,
///
///     cov(x + y) <= (1 + e) P + (1 + 1/e) Q    for each e > 0
///
/// (Young's inequality, on which covariance intersection rests as well: Julier and Uhlmann 2007).
/// If e is the step's share of the path, the bound is tight when all steps have the same error.
/// Most robots do not reach this bound. So it is used only for the reported covariance of the pose;
/// the back-end predicts with the noise that the odometry reports.
class DeadReckoning {
 public:
  /// The length of path up to which errors are independent [m]; a turn by one radian counts as a
  /// metre.
  static constexpr double kIndependent = 1.0;
  /// A standard deviation of the heading beyond which the heading counts as unknown [rad]. Errors
  /// are independent again beyond it, so that covariances stay within what can be computed.
  static constexpr double kUnknownHeading = 1.0;

  /// To be called with each motion in turn.
  void predict(const Motion& motion);
  /// To be called when the pose was set, or corrected by something without errors: no earlier
  /// errors remain.
  void correct() { *this = DeadReckoning(); }
  /// These landmarks are at the places that the map says, without errors.
  void know(const LandmarkMap& landmarks);
  /// To be called with the observations that a step compared with the map.
  /// @param robot the pose after it
  void correct(const std::vector<ObservationInnovation>& innovations, const Pose2& robot);
  /// To be called instead for things without ids, which corrected the pose and were first seen at a
  /// stamp.
  /// @param now stamp of the correction @param robot the pose after it
  void correct(Stamp first_seen, Stamp now, const Pose2& robot);
  /// @return what the correlation of the errors adds to the covariance of a pose (x, y, heading)
  Eigen::Matrix3d covarianceAt(const Pose2& robot) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(way_, length_, independent_, correlated_, before_, of_landmarks_, of_stamps_,
            corrected_);
  }

 private:
  void beginWay();

  Pose2 way_;            ///< since the last correction
  double length_ = 0.0;  ///< [m]
  /// Covariances of the coordinates of the path.
  Eigen::Matrix3d independent_ = Eigen::Matrix3d::Zero(), correlated_ = Eigen::Matrix3d::Zero();
  /// The added covariance when the path began, and when each landmark was first seen; map frame.
  Eigen::Matrix3d before_ = Eigen::Matrix3d::Zero();
  std::map<LandmarkId, Eigen::Matrix3d> of_landmarks_;
  /// A thing without an id that was first seen after one of these stamps leaves this error; the
  /// latest such stamp is used.
  std::map<Stamp, Eigen::Matrix3d> of_stamps_;
  Stamp corrected_;  ///< last, by things without ids
};

}  // namespace slam
