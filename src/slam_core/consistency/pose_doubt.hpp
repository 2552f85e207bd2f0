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

/// Collects evidence against the pose of a back-end that its innovations do not show: the motion by
/// odometry contradicts the one by the sensors, in scale (ScaleDoubt) or as a whole
/// (WayContradiction), or the robot was repeatedly found and lost (Relapses). It says by how much
/// the pose may be wrong, and does not change the back-end's state.
class PoseDoubt {
 public:
  /// To be called when everything starts over, with an empty map.
  void restart();
  /// To be called when a map was loaded, which has a scale of its own. @param robot its pose in
  /// that map
  void load(const Pose2& robot);
  /// To be called when somebody who knows the robot's pose has set it.
  void put(const Pose2& robot) {
    relapses_ = Relapses();
    relocate(robot);
  }
  /// To be called when the robot was found elsewhere: neither this jump nor the first correction
  /// after it counts as motion.
  void relocate(const Pose2& robot) {
    last_ = robot;
    is_relocated_ = true;
    landmarks_ = LandmarkMotion();  // a piece of the path must not contain the jump
  }

  /// To be called with the motions of a step before the other functions. The noise must not be
  /// enlarged.
  void predict(const Motion& motion);
  /// To be called with the landmarks that are seen at the end of these motions, whether the
  /// back-end gets them or not. @param array with covariances, without enlarged noise
  void see(const LandmarkObservationArray& array);
  /// To be called after each step of the back-end.
  void compare(const Pose2& robot);
  /// To be called at the end of each step, when a lost robot may have been found.
  void judgeLoss(bool is_lost, const Pose2& robot, Stamp stamp);

  /// @return what is added to the covariance of a pose (x, y, heading)
  /// @param is_evident the innovations contradict the odometry, so that no difference counts as its
  /// noise
  Eigen::Matrix3d covarianceAt(const Pose2& robot, bool is_evident) const;
  /// A clause about the most serious doubt; empty if there is none.
  std::string reason() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(scale_, landmarks_, scale_of_landmarks_, ways_, relapses_, way_, last_, is_relocated_,
            map_start_);
  }

 private:
  ScaleDoubt::Difference scaleAt(bool is_evident) const;

  ScaleDoubt scale_;  ///< of the back-end's path
  LandmarkMotion landmarks_;
  ScaleDoubt scale_of_landmarks_;  ///< of the path by landmarks
  WayContradiction ways_;
  Relapses relapses_;
  std::optional<Motion> way_;  ///< by odometry since the last step
  std::optional<Pose2> last_;  ///< the robot after the last step
  bool is_relocated_ = false;  ///< since the last step
  /// The robot's position when the map began; nothing in a loaded map [m].
  std::optional<Eigen::Vector2d> map_start_;
};

}  // namespace slam
