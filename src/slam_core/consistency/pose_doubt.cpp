// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/pose_doubt.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slam {
namespace {

/// The same standard deviation in both directions [m], and one of the heading [rad].
Eigen::Matrix3d covarianceOf(double position, double heading) {
  return Eigen::Vector3d(position, position, heading).cwiseAbs2().asDiagonal();
}

}  // namespace

void PoseDoubt::restart() { *this = PoseDoubt(); }

void PoseDoubt::load(const Pose2& robot) {
  map_start_.reset();
  put(robot);
}

void PoseDoubt::predict(const Motion& motion) {
  way_ = way_ ? joined(*way_, motion) : motion;
  landmarks_.predict(motion);
}

void PoseDoubt::see(const LandmarkObservationArray& array) {
  if (const auto piece = landmarks_.see(array)) scale_of_landmarks_.add(*piece);
}

void PoseDoubt::compare(const Pose2& robot) {
  if (last_ && way_ && !is_relocated_) {
    const auto increment = last_->between(robot);
    scale_.add(*way_, increment);
    ways_.add(*way_, increment);
  }
  if (!last_) map_start_ = robot.position();
  last_ = robot;
  is_relocated_ = false;
  way_.reset();
}

void PoseDoubt::judgeLoss(bool is_lost, const Pose2& robot, Stamp stamp) {
  relapses_.judge(is_lost, robot.position(), stamp);
}

ScaleDoubt::Difference PoseDoubt::scaleAt(bool is_evident) const {
  if (!map_start_) return {};
  const auto larger = [](double a, double b) { return std::abs(a) > std::abs(b) ? a : b; };
  const auto by_backend = is_evident ? scale_.difference() : scale_.beyondNoise();
  const auto by_landmarks = scale_of_landmarks_.beyondNoise();
  return {larger(by_backend.scale, by_landmarks.scale), larger(by_backend.turn, by_landmarks.turn)};
}

Eigen::Matrix3d PoseDoubt::covarianceAt(const Pose2& robot, bool is_evident) const {
  constexpr double kSigmaHeadingOfRelapse = 0.2;  // [rad]
  Eigen::Matrix3d P = Eigen::Matrix3d::Zero();
  if (map_start_) P = slam::covarianceOf(scaleAt(is_evident), robot.position() - *map_start_);
  if (ways_.isEvident()) {
    const auto apart = ways_.apart();
    P += covarianceOf(apart.position, apart.heading);
  }
  if (relapses_.isOnProbation()) P += covarianceOf(relapses_.extent(), kSigmaHeadingOfRelapse);
  return P;
}

std::string PoseDoubt::reason() const {
  if (relapses_.isOnProbation())
    return fmt::format("the places at which it was found have proved wrong ({} so far)",
                       relapses_.count());
  if (ways_.isEvident())
    return fmt::format(
        "odometry and sensors contradict each other, and lead {:.1f} m apart: the wheels slip or "
        "stand, or a sensor repeats itself",
        ways_.apart().position);
  const auto [scale, turn] = scaleAt(false);
  if (scale != 0.0)
    return fmt::format(
        "the way by the sensors is {:.0f} % {} than the one by odometry: one of them has a wrong "
        "scale",
        100.0 * std::abs(scale), scale > 0.0 ? "longer" : "shorter");
  if (turn != 0.0)
    return fmt::format(
        "the way by the sensors points {:.2f} rad elsewhere than the one by odometry: a sensor is "
        "mounted otherwise than configured",
        turn);
  return "";
}

}  // namespace slam
