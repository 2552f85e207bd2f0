// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/step_source.hpp"

#include <utility>

namespace slam_ros {

template <class Input>
void BackendAlone::takeScans(const Input& input) {
  if (!usesScans()) return;
  laser_.set(input);
  const auto& scan = laser_.scan();
  do {
    if (const auto status = laser_.next(); !status.isOk()) laser_status_ = status;
    if (scan) estimator_.set(*scan);
  } while (scan);
}

template void BackendAlone::takeScans(const slam::LaserSweep&);
template void BackendAlone::takeScans(const slam::LaserMount&);

slam::Status BackendAlone::execute() {
  const auto status = estimator_.execute();
  const auto laser_status = std::exchange(laser_status_, slam::Status::ok());
  return laser_status.isOk() ? status : laser_status;
}

slam::Counters BackendAlone::counters() const {
  slam::Counters all = estimator_.counters();
  for (const auto& [reason, count] : laser_.counters().all()) all.add("laser_" + reason, count);
  return all;
}

void BackendAlone::reset() {
  laser_.reset();
  estimator_.reset();
  laser_status_ = slam::Status::ok();
}

}  // namespace slam_ros
