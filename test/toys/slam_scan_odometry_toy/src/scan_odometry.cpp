// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scan_odometry.hpp"

#include <utility>

#include "slam_core/contract/registry.hpp"

namespace slam_toy {
namespace {

const slam::Registrar<slam::OdometrySource, ScanOdometry> kRegistrar("scan_toy");

}  // namespace

void ScanOdometry::describe(slam::Ports& ports) {
  ports.takes<slam::LaserScan>("scan", "laser scans", this);
  ports.makes<slam::Motion>("motion", motion_);
}

void ScanOdometry::reset() {
  scan_.reset();
  last_.reset();
  points_.clear();
  twist_.setZero();
  pose_ = {};
  motion_.reset();
  sequence_ = 0;
  counters_.clear();
}

slam::Status ScanOdometry::execute() {
  motion_.reset();
  if (!scan_) return slam::Status::ok();
  const auto scan = *std::exchange(scan_, std::nullopt);
  if (last_ && scan.stamp <= *last_) {
    counters_.add("late");
    return slam::Status::warning("a scan that is not newer than the last is left out");
  }
  const auto points = pointsOf(scan);
  auto status = slam::Status::ok();
  if (last_) {
    const double dt = slam::seconds(scan.stamp - *last_);
    const auto assumed = coasted(twist_, dt);
    const auto found = align(points_, points, assumed.pose);
    if (!found) {
      counters_.add("coasted");
      status = slam::Status::warning(
          "a scan could not be aligned with the one before: the robot is taken to have gone on at "
          "its last velocity");
    }
    moveBy(found.value_or(assumed), scan.stamp);
  }
  last_ = scan.stamp;
  points_ = points;
  return status;
}

void ScanOdometry::moveBy(const Alignment& step, slam::Stamp end) {
  slam::Motion motion;
  motion.sequence = sequence_++;
  motion.start = *last_;
  motion.end = end;
  motion.increment = step.pose;
  motion.covariance = step.covariance;
  motion.odometry_start = pose_;
  pose_ = motion.odometry_end = pose_ * step.pose;
  twist_ = step.pose.log() / slam::seconds(end - *last_);
  motion_ = motion;
}

}  // namespace slam_toy
