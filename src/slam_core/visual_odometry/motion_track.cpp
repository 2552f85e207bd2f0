// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/motion_track.hpp"

namespace slam::visual_odometry {
namespace {

constexpr Duration kKept = std::chrono::seconds(30);  // longer than images are ever held

}  // namespace

void MotionTrack::add(const Motion& motion) {
  if (!motions_.empty() && motion.start < motions_.back().end) motions_.clear();  // a new run
  motions_.push_back(motion);
  while (motions_.front().end < motion.end - kKept) motions_.pop_front();
}

std::optional<Stamp> MotionTrack::end() const {
  if (motions_.empty()) return std::nullopt;
  return motions_.back().end;
}

std::optional<GapMotion> MotionTrack::between(Stamp start, Stamp end) const {
  GapMotion gap;
  Stamp reached = start;
  for (Motion motion : motions_) {
    if (motion.end <= start) continue;
    if (motion.start < start) motion = split(motion, start).second;
    if (motion.start != reached) return std::nullopt;
    if (motion.end > end) motion = split(motion, end).first;
    Eigen::Matrix3d J_gap, J_step;
    gap.increment = gap.increment.compose(motion.increment, &J_gap, &J_step);
    gap.covariance = J_gap * gap.covariance * J_gap.transpose() +
                     J_step * motion.covariance * J_step.transpose();
    reached = motion.end;
    if (reached >= end) return gap;
  }
  return std::nullopt;
}

}  // namespace slam::visual_odometry
