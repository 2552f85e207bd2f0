// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/Path.h>

#include <cstddef>
#include <string>

namespace slam_ros {

/// A path for display, whose message has a bounded size however long the run is. When it is full,
/// every other pose is left out, and from then on one of twice as many poses is kept. It always has
/// the first and the last pose. All poses are in trajectory.tum.
class ThinnedPath {
 public:
  static constexpr std::size_t kMostPoses = 4000;

  explicit ThinnedPath(const std::string& frame) { path_.header.frame_id = frame; }

  void add(const geometry_msgs::PoseStamped& pose);
  const nav_msgs::Path& message() const { return path_; }

 private:
  void thin();

  nav_msgs::Path path_;
  std::size_t stride_ = 1;      ///< one of so many poses is kept
  std::size_t since_kept_ = 0;  ///< poses since the last kept one: the last in the path, if not 0
};

}  // namespace slam_ros
