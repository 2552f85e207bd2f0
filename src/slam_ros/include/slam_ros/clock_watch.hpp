// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/time.h>

namespace slam_ros {

/// Notices that /clock has jumped back, since a bag was restarted. A wall clock that is set back
/// does not count.
class ClockWatch {
 public:
  struct Jump {
    ros::Time from, to;
  };

  /// @return whether the clock is behind what it was at the last call
  bool hasJumpedBack() {
    const auto now = ros::Time::now();
    const bool back = ros::Time::isSimTime() && now < last_;
    if (back) jump_ = {last_, now};
    last_ = now;
    return back;
  }
  const Jump& jump() const { return jump_; }

 private:
  ros::Time last_;
  Jump jump_;
};

}  // namespace slam_ros
