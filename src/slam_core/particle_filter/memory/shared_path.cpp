// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/memory/shared_path.hpp"

#include <algorithm>
#include <new>

namespace slam::particle_filter {

void SharedPath::Memory::addStep(Stamp stamp, const Pose2& increment) {
  steps_.push_back({stamp, steps_.empty() ? Pose2() : steps_.back().odometry * increment});
}

SharedPath::~SharedPath() {
  for (Link* link = last_; link != nullptr && --link->count == 0;) {
    Link* const before = link->before;
    memory_->links_.release(link, 0);
    link = before;
  }
}

void SharedPath::append(const Pose2& pose) {
  if (memory_->steps_.empty()) return;
  const auto newest = memory_->steps_.size() - 1;
  if (last_ != nullptr && last_->step == newest) return;
  last_ = new (memory_->links_.allocate(0)) Link{pose, newest, last_, 1};
}

std::vector<SharedPath::Knot> SharedPath::knots(const Pose2& now) const {
  const auto newest = memory_->steps_.size() - 1;
  std::vector<Knot> knots;
  if (last_ == nullptr || last_->step != newest) knots.push_back({newest, now});
  for (const Link* link = last_; link != nullptr; link = link->before)
    knots.push_back({link->step, link->pose});
  std::reverse(knots.begin(), knots.end());
  return knots;
}

std::vector<StampedPose> SharedPath::poses(const Pose2& now) const {
  const auto& steps = memory_->steps_;
  std::vector<StampedPose> poses;
  if (steps.empty()) return poses;
  poses.reserve(steps.size());
  const auto all = knots(now);
  const Knot* from = &all.front();  // before the first one nothing is known but the odometry
  for (const auto& to : all) {
    const Pose2 way = steps[from->step].odometry.between(steps[to.step].odometry);
    const Pose2 error = (from->pose * way).between(to.pose);
    const auto length = static_cast<double>(to.step - from->step);
    while (poses.size() < to.step) {
      const auto k = poses.size();
      const Pose2 moved = from->pose * steps[from->step].odometry.between(steps[k].odometry);
      const double share = k > from->step ? static_cast<double>(k - from->step) / length : 0.0;
      poses.push_back({steps[k].stamp, moved * error.part(share)});
    }
    poses.push_back({steps[to.step].stamp, to.pose});
    from = &to;
  }
  return poses;
}

}  // namespace slam::particle_filter
