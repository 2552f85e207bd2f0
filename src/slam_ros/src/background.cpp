// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/background.hpp"

#include <chrono>
#include <utility>

namespace slam_ros {

bool Background::tryRun(std::function<void()> work) {
  if (isBusy()) return false;
  work_ = std::async(std::launch::async, std::move(work));
  return true;
}

bool Background::isBusy() const {
  return work_.valid() && work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void Background::wait() const {
  if (work_.valid()) work_.wait();
}

Background::~Background() { wait(); }

}  // namespace slam_ros
