// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/motion_track.hpp"

namespace slam {
namespace {

constexpr Duration kKept = std::chrono::seconds(30);  // longer than data are ever held for it

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

std::optional<Motion> MotionTrack::between(Stamp start, Stamp end) const {
  std::optional<Motion> whole;
  Stamp reached = start;
  for (Motion motion : motions_) {
    if (motion.end <= start) continue;
    if (motion.start < start) motion = split(motion, start).second;
    if (motion.start != reached) return std::nullopt;
    if (motion.end > end) motion = split(motion, end).first;
    reached = motion.end;
    whole = whole ? joined(*whole, motion) : motion;
    if (reached >= end) return whole;
  }
  return std::nullopt;
}

}  // namespace slam
