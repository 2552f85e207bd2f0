// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_wheel_odometry.hpp"

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::visual_odometry {
namespace {

const Registrar<OdometrySource, VisualWheelOdometry> kWheelRegistrar("visual_wheel");

constexpr Duration kPatience = std::chrono::seconds(1);  // of images, for wheels that are silent
constexpr std::size_t kCapacity = 100;

}  // namespace

VisualWheelOdometry::VisualWheelOdometry() {
  visual_.setGapSource([this](Stamp start, Stamp end) { return track_.between(start, end); });
}

void VisualWheelOdometry::configure(Settings& settings) {
  FaultCollector faults;
  faults.attempt([&] {
    wheels_ = Registry<OdometrySource>::instance().create("wheel");
    wheels_->configure(settings);
    wheel_ports_ = portsOf(*wheels_);
  });
  faults.attempt([&] { visual_.configure(settings); });
  faults.raise();
  reset();
}

void VisualWheelOdometry::describe(Ports& ports) {
  ports.takes<CameraView>(CeilingCameraConfig::kSection, "images of the ceiling", this);
  ports.takes<OdometrySample>("odom", "odometry", this);
  ports.makes<Motion>("motion", visual_.motion());
}

void VisualWheelOdometry::reset() {
  wheels_->reset();
  visual_.reset();
  track_.clear();
  waiting_.clear();
  own_counters_.clear();
  has_sample_ = is_handing_over_ = false;
}

void VisualWheelOdometry::set(const OdometrySample& sample) {
  wheel_ports_.input("odom", kindOf<OdometrySample>())->set(&sample);
  has_sample_ = true;
}

Status VisualWheelOdometry::execute() {
  Status wheel_status;
  if (has_sample_) {
    has_sample_ = false;
    wheel_status = wheels_->execute();
    if (wheels_->motion()) track_.add(*wheels_->motion());
  }
  is_handing_over_ = handOverView();
  const auto status = visual_.execute();
  return status.isOk() ? wheel_status : status;
}

/// Whether a view went on to the visual part.
bool VisualWheelOdometry::handOverView() {
  if (waiting_.empty()) return false;
  const auto& view = waiting_.front();
  const bool is_covered = track_.end() && *track_.end() >= view.stamp;
  if (!is_covered) {
    const bool is_patient = waiting_.back().stamp - view.stamp < kPatience &&
                            waiting_.back().stamp >= view.stamp && waiting_.size() <= kCapacity;
    if (is_patient) return false;
    own_counters_.add("wheels_missing");
  }
  visual_.set(view);
  waiting_.pop_front();
  return true;
}

Counters VisualWheelOdometry::counters() const {
  auto all = visual_.counters();
  all.add(own_counters_);
  all.add(wheels_->counters());
  return all;
}

std::uint64_t VisualWheelOdometry::dropped() const { return wheels_->dropped(); }

}  // namespace slam::visual_odometry
