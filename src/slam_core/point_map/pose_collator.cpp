// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/pose_collator.hpp"

#include <utility>

namespace slam::point_map {

void PoseCollator::push(Motion motion) {
  const auto stamp = motion.end;
  const auto sequence = motion.sequence;
  const auto start = motion.start;
  motions_.push(stamp, sequence, std::move(motion), counters_);
  if (!begin_) begin_ = start;
  restartWhenAllWentBack();
}

void PoseCollator::push(const FilterPose& pose) {
  if (pose.stamp == lastPose()) return;
  poses_.push(pose.stamp, pose_sequence_++, pose, counters_);
  restartWhenAllWentBack();
}

void PoseCollator::push(LaserScan scan) {
  const auto stamp = scan.stamp;
  const auto sequence = scan.sequence;
  scans_.push(stamp, sequence, std::move(scan), counters_);
  restartWhenAllWentBack();
}

std::optional<PoseCollator::Placed> PoseCollator::next() {
  if (scans_.items().empty()) forgetOldest();
  while (!scans_.items().empty()) {
    const auto stamp = scans_.items().front().stamp;
    const bool is_due =
        lastPose() && *lastPose() >= stamp && lastMotion() && *lastMotion() >= stamp;
    if (!is_due) return std::nullopt;
    takePoses(stamp);
    const std::string hindrance = hindranceAt(stamp);
    if (hindrance.empty()) {
      const auto pose = carriedTo(stamp);
      scans_.goneTo(stamp);
      return Placed{scans_.pop().value, pose, std::exchange(restart_, false)};
    }
    counters_.add(hindrance);
    scans_.pop();
  }
  return std::nullopt;
}

std::string PoseCollator::hindranceAt(Stamp stamp) const {
  if (!pose_) return "before_pose";
  if (pose_->stamp > stamp) return "late";
  return pose_->stamp < *begin_ && pose_->stamp < stamp ? "before_motion" : "";
}

void PoseCollator::forgetOldest() {
  const auto& poses = poses_.items();
  while (!poses.empty() && (poses.size() >= kKept || motions_.items().size() >= kKept))
    takePoses(poses.front().stamp);
}

void PoseCollator::takePoses(Stamp up_to) {
  const auto& poses = poses_.items();
  const auto& motions = motions_.items();
  while (!poses.empty() && poses.front().stamp <= up_to) pose_ = poses_.pop().value;
  if (!pose_) return;
  poses_.goneTo(pose_->stamp);
  motions_.goneTo(pose_->stamp);
  while (!motions.empty() && motions.front().stamp <= pose_->stamp) motions_.pop();
}

Pose2 PoseCollator::carriedTo(Stamp stamp) {
  auto pose = pose_->pose();
  for (const auto& item : motions_.items()) {
    auto motion = item.value;
    if (motion.start >= stamp) break;
    if (motion.start < pose_->stamp) motion = split(motion, pose_->stamp).second;
    if (motion.end > stamp) motion = split(motion, stamp).first;
    pose = pose * motion.increment;
  }
  return pose;
}

void PoseCollator::restartWhenAllWentBack() {
  const auto has_gone_back = [](const auto& source) {
    return source.beganAnew() || !source.stamps().last();
  };
  if (!motions_.beganAnew() || !has_gone_back(poses_) || !has_gone_back(scans_)) return;
  motions_.restart();
  begin_ = motions_.items().front().value.start;
  poses_.restart();
  scans_.restart();
  pose_.reset();
  restart_ = true;
  counters_.add("restart");
}

}  // namespace slam::point_map
