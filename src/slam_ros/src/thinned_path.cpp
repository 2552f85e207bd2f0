// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/thinned_path.hpp"

namespace slam_ros {

void ThinnedPath::add(const geometry_msgs::PoseStamped& pose) {
  if (since_kept_ > 0) path_.poses.pop_back();  // it was only the last one
  path_.poses.push_back(pose);
  path_.header.stamp = pose.header.stamp;
  const bool is_first = path_.poses.size() == 1;
  since_kept_ = is_first ? 0 : (since_kept_ + 1) % stride_;
  if (path_.poses.size() >= kMostPoses && since_kept_ == 0) thin();
}

/// The first one is kept, and every second one after it; the last one stays for the time being.
void ThinnedPath::thin() {
  auto& poses = path_.poses;
  const auto last = poses.back();
  const bool last_is_kept = (poses.size() - 1) % 2 == 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < poses.size(); i += 2) poses[kept++] = poses[i];
  poses.resize(kept);
  if (!last_is_kept) {
    poses.push_back(last);
    since_kept_ = stride_;
  }
  stride_ *= 2;
}

}  // namespace slam_ros
