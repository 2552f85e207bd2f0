// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_odometry/laser_wheel_odometry.hpp"

#include "slam_core/contract/registry.hpp"

namespace slam::laser_odometry {
namespace {

const Registrar<OdometrySource, LaserWheelOdometry> kWheelRegistrar("laser_wheel");

}  // namespace

LaserWheelOdometry::LaserWheelOdometry() {
  laser_.setMotionSource([this](Stamp start, Stamp end) { return wheels_.between(start, end); });
}

void LaserWheelOdometry::configure(Settings& settings) {
  FaultCollector faults;
  faults.attempt([&] { wheels_.configure(settings); });
  faults.attempt([&] { laser_.configure(settings); });
  faults.raise();
  reset();
}

void LaserWheelOdometry::describe(Ports& ports) {
  ports.takes<LaserScan>("scan", "laser scans", &wheels_);
  ports.takes<OdometrySample>("odom", "odometry", &wheels_);
  ports.makes<Motion>("motion", laser_.motion());
}

void LaserWheelOdometry::reset() {
  wheels_.reset();
  laser_.reset();
  is_handing_over_ = false;
}

Status LaserWheelOdometry::execute() {
  const auto wheel_status = wheels_.execute();
  const auto scan = wheels_.next();
  is_handing_over_ = scan.has_value();
  if (scan) laser_.set(*scan);
  const auto status = laser_.execute();
  return status.isOk() ? wheel_status : status;
}

Counters LaserWheelOdometry::counters() const {
  auto all = laser_.counters();
  all.add(wheels_.counters());
  return all;
}

}  // namespace slam::laser_odometry
