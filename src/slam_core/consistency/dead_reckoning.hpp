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

/// Dead reckoning: the way since an observation last corrected the pose. A landmark that was first
/// seen after such a way is where the robot was taken to be then: it corrects what came after, and
/// leaves what went before.
///
/// An odometry source takes the errors of its increments for independent. Over a piece of a metre
/// it may, with a variance that covers what wheels of slightly wrong sizes add; but such an error
/// is the same in each piece, and over longer ways it grows with the way instead of its root. So
/// beyond a metre the errors are taken to be correlated as much as they can be. For an error x of
/// the way so far, of covariance P, and an error y of a further step, of covariance Q, correlated
/// in any way,
///
///     cov(x + y) <= (1 + e) P + (1 + 1/e) Q    for each e > 0
///
/// (Young's inequality, on which covariance intersection rests as well: Julier and Uhlmann 2007).
/// With e the step's share of the way the bound is tight where all steps have the same error.
/// It is a bound, which most robots do not reach: so it counts in what is reported of the pose, and
/// the back-end predicts by the noise that the odometry has.
class DeadReckoning {
 public:
  /// The way up to which errors are independent; a turn by one radian counts as a metre [m].
  static constexpr double kIndependent = 1.0;
  /// A standard deviation of the heading beyond which nothing is left to be lost: errors count as
  /// independent again, so that covariances stay far from what cannot be computed with [rad].
  static constexpr double kUnknownHeading = 1.0;

  /// To be called with each motion in turn.
  void predict(const Motion& motion);
  /// The pose was set, or corrected by what is right as a whole: nothing is left of former ways.
  void correct() { *this = DeadReckoning(); }
  /// These landmarks are where the map says.
  void know(const LandmarkMap& landmarks);
  /// To be called with the observations that a step compared with the map.
  /// @param robot the pose after it
  void correct(const std::vector<ObservationInnovation>& innovations, const Pose2& robot);
  /// To be called instead where things have no ids: they corrected the pose, and were first seen
  /// at a stamp.
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
  /// Covariances of the coordinates of the way.
  Eigen::Matrix3d independent_ = Eigen::Matrix3d::Zero(), correlated_ = Eigen::Matrix3d::Zero();
  /// What was added when the way began, and when each landmark was first seen; map frame.
  Eigen::Matrix3d before_ = Eigen::Matrix3d::Zero();
  std::map<LandmarkId, Eigen::Matrix3d> of_landmarks_;
  /// A thing without an id that was first seen after one of these stamps leaves this error; the
  /// latest such stamp counts.
  std::map<Stamp, Eigen::Matrix3d> of_stamps_;
  Stamp corrected_;  ///< last, by what has no ids
};

}  // namespace slam
