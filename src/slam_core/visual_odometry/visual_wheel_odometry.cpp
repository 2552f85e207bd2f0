// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_wheel_odometry.hpp"

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::visual_odometry {
namespace {

const Registrar<OdometrySource, VisualWheelOdometry> kWheelRegistrar("visual_wheel");

}  // namespace

VisualWheelOdometry::VisualWheelOdometry() {
  visual_.setGapSource([this](Stamp start, Stamp end) -> std::optional<GapMotion> {
    const auto motion = wheels_.between(start, end);
    if (!motion) return std::nullopt;
    return GapMotion{motion->increment, motion->covariance};
  });
}

void VisualWheelOdometry::configure(Settings& settings) {
  FaultCollector faults;
  faults.attempt([&] { wheels_.configure(settings); });
  faults.attempt([&] { visual_.configure(settings); });
  faults.raise();
  reset();
}

void VisualWheelOdometry::describe(Ports& ports) {
  ports.takes<CameraView>(CeilingCameraConfig::kSection, "images of the ceiling", &wheels_);
  ports.takes<OdometrySample>("odom", "odometry", &wheels_);
  ports.makes<Motion>("motion", visual_.motion());
}

void VisualWheelOdometry::reset() {
  wheels_.reset();
  visual_.reset();
  is_handing_over_ = false;
}

Status VisualWheelOdometry::execute() {
  const auto wheel_status = wheels_.execute();
  const auto view = wheels_.next();
  is_handing_over_ = view.has_value();
  if (view) visual_.set(*view);
  const auto status = visual_.execute();
  return status.isOk() ? wheel_status : status;
}

Counters VisualWheelOdometry::counters() const {
  auto all = visual_.counters();
  all.add(wheels_.counters());
  return all;
}

}  // namespace slam::visual_odometry
