// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "slam_core/consistency/landmark_motion.hpp"
#include "slam_core/consistency/relapses.hpp"
#include "slam_core/consistency/scale_doubt.hpp"
#include "slam_core/consistency/way_contradiction.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// What speaks against the pose of any back-end although its innovations do not: the motion by
/// odometry contradicts the one by the sensors, in scale (ScaleDoubt) or as a whole
/// (WayContradiction), or the robot has been found and lost in turn (Relapses). It says by how much
/// the pose may be wrong; the back-end's own state stays as it is.
class PoseDoubt {
 public:
  /// Everything starts over, with an empty map.
  void restart();
  /// A map was loaded, which has a scale of its own. @param robot its pose in that map
  void load(const Pose2& robot);
  /// Somebody who knows where the robot is has put it there.
  void put(const Pose2& robot) {
    relapses_ = Relapses();
    relocate(robot);
  }
  /// The robot was found elsewhere: how it came there is no motion, nor is the first correction.
  void relocate(const Pose2& robot) {
    last_ = robot;
    is_relocated_ = true;
    landmarks_ = LandmarkMotion();  // a piece of the way does not lead across it
  }

  /// To be called with the motions of a step before the others, without enlarged noise.
  void predict(const Motion& motion);
  /// To be called with the landmarks that are seen at the end of these motions, whether the
  /// back-end gets them or not. @param array with covariances, without enlarged noise
  void see(const LandmarkObservationArray& array);
  /// To be called after each step of the back-end.
  void compare(const Pose2& robot);
  /// To be called at the end of each step, when a lost robot may have been found.
  void judgeLoss(bool is_lost, const Pose2& robot, Stamp stamp);

  /// @return what is added to the covariance of a pose (x, y, heading)
  /// @param is_evident the innovations contradict the odometry: no difference is left to its noise
  Eigen::Matrix3d covarianceAt(const Pose2& robot, bool is_evident) const;
  /// A clause on the gravest doubt; empty where there is none.
  std::string reason() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(scale_, landmarks_, scale_of_landmarks_, ways_, relapses_, way_, last_, is_relocated_,
            map_start_);
  }

 private:
  ScaleDoubt::Difference scaleAt(bool is_evident) const;

  ScaleDoubt scale_;  ///< of the back-end's way
  LandmarkMotion landmarks_;
  ScaleDoubt scale_of_landmarks_;  ///< of their way
  WayContradiction ways_;
  Relapses relapses_;
  std::optional<Motion> way_;  ///< by odometry since the last step
  std::optional<Pose2> last_;  ///< the robot after the last step
  bool is_relocated_ = false;  ///< since the last step
  /// The robot was here when the map began; nothing in a map that was loaded [m].
  std::optional<Eigen::Vector2d> map_start_;
};

}  // namespace slam
