// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/shared_path.hpp"

#include <algorithm>
#include <new>

namespace slam::particle_filter {

SharedPath::~SharedPath() {
  for (Link* link = last_; link != nullptr && --link->count == 0;) {
    Link* const before = link->before;
    memory_->links_.release(link, 0);
    link = before;
  }
}

void SharedPath::append(const StampedPose& pose) {
  last_ = new (memory_->links_.allocate(0)) Link{pose, last_, 1};
}

std::vector<StampedPose> SharedPath::poses() const {
  std::vector<StampedPose> poses;
  for (const Link* link = last_; link != nullptr; link = link->before) poses.push_back(link->pose);
  std::reverse(poses.begin(), poses.end());
  return poses;
}

}  // namespace slam::particle_filter
