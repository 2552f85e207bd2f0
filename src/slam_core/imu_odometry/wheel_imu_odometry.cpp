// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu_odometry/wheel_imu_odometry.hpp"

#include <utility>

#include "slam_core/contract/registry.hpp"
#include "slam_core/imu_odometry/turned_motion.hpp"

namespace slam::imu_odometry {
namespace {

const Registrar<OdometrySource, WheelImuOdometry> kWheelImuRegistrar("wheel_imu");

/// A motion of the wheels waits so long for the gyro.
constexpr Duration kGyroPatience = std::chrono::seconds(1);

}  // namespace

void WheelImuOdometry::configure(Settings& settings) {
  FaultCollector faults;
  faults.attempt([&] {
    wheels_ = Registry<OdometrySource>::instance().create("wheel");
    wheels_->configure(settings);
    wheel_ports_ = portsOf(*wheels_);
  });
  faults.attempt([&] {
    gyro_.configure(settings.read<ImuConfig>(),
                    {"the wheels", "the wheels' heading is used meanwhile"});
  });
  faults.raise();
  reset();
}

void WheelImuOdometry::describe(Ports& ports) {
  ports.takes<OdometrySample>("odom", "odometry", this);
  ports.takes<ImuSample>("imu", "an IMU's angular velocities", this);
  ports.makes<Motion>("motion", motion_);
}

void WheelImuOdometry::set(const OdometrySample& sample) {
  wheel_ports_.input("odom", kindOf<OdometrySample>())->set(&sample);
  has_sample_ = true;
}

void WheelImuOdometry::reset() {
  wheels_->reset();
  has_sample_ = false;
  waiting_.clear();
  gyro_.reset();
  standstill_.reset();
  motion_.reset();
  next_sequence_ = 0;
}

Status WheelImuOdometry::execute() {
  motion_.reset();
  const auto wheel_status = takeWheels();
  if (!isBusy()) return wheel_status;
  const Motion wheels = std::move(waiting_.front());
  waiting_.pop_front();
  return moreUrgent(wheel_status, follow(wheels));
}

Status WheelImuOdometry::takeWheels() {
  if (!std::exchange(has_sample_, false)) return Status::ok();
  const auto status = wheels_->execute();
  const auto& motion = wheels_->motion();
  if (!motion) return status;
  if (!waiting_.empty() && motion->start < waiting_.back().start) waiting_.clear();  // a new run
  waiting_.push_back(*motion);
  return status;
}

bool WheelImuOdometry::isDue(const Motion& wheels) const {
  const auto covered = gyro_.track().end();
  return (covered && *covered >= wheels.end) || waiting_.back().end - wheels.end >= kGyroPatience;
}

Status WheelImuOdometry::follow(const Motion& wheels) {
  const auto turn = gyro_.track().between(wheels.start, wheels.end);
  standstill_.add(wheels);
  const bool is_resting = standstill_.isResting();
  const auto use = gyro_.judge(turn, wheels, is_resting);
  motion_ = use == gyro::GyroUse::kTurn ? turned(wheels, *turn) : wheels;
  motion_->sequence = next_sequence_++;
  return gyro_.learn(turn, wheels, use, is_resting, use == gyro::GyroUse::kTurn);
}

/// While no turn has proven the gyro, what it contradicts the wheels by counts as an error of its
/// own.
Motion WheelImuOdometry::turned(const Motion& wheels, const gyro::GyroTurn& turn) const {
  const auto& calibration = gyro_.calibration();
  double variance = calibration.variance(turn);
  if (!gyro_.isProven()) {
    const double difference = calibration.angle(turn) - wheels.increment.theta();
    variance += difference * difference;
  }
  return turnedMotion(wheels, turn, calibration.bias(), variance);
}

Counters WheelImuOdometry::counters() const {
  auto all = wheels_->counters();
  all.add(gyro_.counters());
  return all;
}

std::uint64_t WheelImuOdometry::dropped() const { return wheels_->dropped() + gyro_.dropped(); }

void WheelImuOdometry::saveState(ArchiveWriter& archive) const { archive(*this); }

void WheelImuOdometry::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::imu_odometry
