// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu_odometry/wheel_imu_odometry.hpp"

#include <cmath>
#include <utility>

#include "slam_core/contract/registry.hpp"
#include "slam_core/imu_odometry/turned_motion.hpp"

namespace slam::imu_odometry {
namespace {

const Registrar<OdometrySource, WheelImuOdometry> kWheelImuRegistrar("wheel_imu");

/// The wheels' motion waits so long for the gyro; only then is a silent gyro reported.
constexpr Duration kGyroPatience = std::chrono::seconds(1);
constexpr double kTurnRate = 0.05;  // above which wheels turn, or contradict [rad/s]

double secondsOf(const Motion& motion) { return seconds(motion.end - motion.start); }

bool turns(const Motion& wheels) {
  return std::abs(wheels.increment.theta()) > kTurnRate * secondsOf(wheels);
}

}  // namespace

void WheelImuOdometry::configure(Settings& settings) {
  FaultCollector faults;
  faults.attempt([&] {
    wheels_ = Registry<OdometrySource>::instance().create("wheel");
    wheels_->configure(settings);
    wheel_ports_ = portsOf(*wheels_);
  });
  faults.attempt([&] { settings.read(config_); });
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

void WheelImuOdometry::set(const ImuSample& sample) { track_.add(sample, counters_); }

void WheelImuOdometry::reset() {
  wheels_->reset();
  has_sample_ = false;
  waiting_.clear();
  track_.clear();
  calibration_ = GyroCalibration(config_);
  trust_.reset();
  standstill_.reset();
  said_ = Heading::kGyro;
  silent_for_ = {};
  motion_.reset();
  next_sequence_ = 0;
  counters_.clear();
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
  return (track_.end() && *track_.end() >= wheels.end) ||
         waiting_.back().end - wheels.end >= kGyroPatience;
}

Status WheelImuOdometry::follow(const Motion& wheels) {
  const auto turn = track_.between(wheels.start, wheels.end);
  track_.forgetBefore(wheels.end);
  standstill_.add(wheels);
  const auto heading = headingOf(wheels, turn);
  motion_ = heading == Heading::kGyro ? turned(wheels, *turn) : wheels;
  motion_->sequence = next_sequence_++;
  learn(wheels, turn, heading);
  const bool has_turned = heading == Heading::kGyro && !turn->is_repeated && turns(wheels);
  return explain(wheels.end - wheels.start, heading, has_turned);
}

WheelImuOdometry::Heading WheelImuOdometry::headingOf(const Motion& wheels,
                                                      const std::optional<GyroTurn>& turn) const {
  if (!turn) return Heading::kSilent;
  const double angle = calibration_.angle(*turn);
  const bool contradicts = std::abs(angle - wheels.increment.theta()) > kTurnRate * turn->seconds;
  if (turn->is_repeated && contradicts) return Heading::kStuck;
  const bool is_proven = trust_.verdict() == GyroTrust::Verdict::kProven;
  if (standstill_.isResting() && (!is_proven || calibration_.rests(*turn))) return Heading::kRest;
  if (is_proven && GyroTrust::isBurst(turn->fastest, wheels)) return Heading::kBurst;
  const bool is_believed = trust_.believes(angle, wheels, std::sqrt(calibration_.biasVariance()));
  return is_believed ? Heading::kGyro : Heading::kImplausible;
}

/// While no turn has proven the gyro, what it contradicts the wheels by counts as an error of its
/// own.
Motion WheelImuOdometry::turned(const Motion& wheels, const GyroTurn& turn) const {
  double variance = calibration_.variance(turn);
  if (trust_.verdict() != GyroTrust::Verdict::kProven) {
    const double difference = calibration_.angle(turn) - wheels.increment.theta();
    variance += difference * difference;
  }
  return turnedMotion(wheels, turn, calibration_.bias(), variance);
}

void WheelImuOdometry::learn(const Motion& wheels, const std::optional<GyroTurn>& turn,
                             Heading heading) {
  calibration_.predict(secondsOf(wheels), motion_->increment.theta(), heading == Heading::kGyro);
  if (!turn || heading == Heading::kStuck || heading == Heading::kBurst)
    return calibration_.pause();
  trust_.add(calibration_.angle(*turn), wheels, std::sqrt(calibration_.biasVariance()));
  if (standstill_.isResting())
    calibration_.learnAtRest(*turn);
  else if (trust_.verdict() == GyroTrust::Verdict::kProven)
    calibration_.learnBesideWheels(*turn, wheels);
  else
    calibration_.pause();
}

/// Each reason is said once, until the gyro has measured a turn again.
Status WheelImuOdometry::explain(Duration interval, Heading heading, bool has_measured_turn) {
  if (has_measured_turn) said_ = Heading::kGyro;
  if (heading == Heading::kSilent) counters_.add("gyro_silent");
  if (heading == Heading::kStuck) counters_.add("gyro_stuck");
  if (heading == Heading::kImplausible || heading == Heading::kBurst)
    counters_.add("gyro_implausible");
  silent_for_ = heading == Heading::kSilent ? silent_for_ + interval : Duration{};
  const auto sentence = sentenceOf(heading);
  if (sentence.empty() || said_ == heading) return Status::ok();
  said_ = heading;
  return Status::warning(sentence + "; the wheels' heading is used meanwhile");
}

std::string WheelImuOdometry::sentenceOf(Heading heading) const {
  using Verdict = GyroTrust::Verdict;
  if (heading == Heading::kSilent && silent_for_ >= kGyroPatience)
    return "the IMU is silent; see whether its driver runs and whether its stamps are right";
  if (heading == Heading::kStuck)
    return "the IMU repeats one angular velocity, which the wheels contradict; start its driver "
           "again";
  if (heading == Heading::kBurst)
    return "the IMU measures a turn that is faster than robots spin, and the wheels do not confirm "
           "it; see whether its cable is loose";
  if (heading != Heading::kImplausible) return "";
  if (trust_.verdict() == Verdict::kTooLarge)
    return "the IMU measures turns several times as large as the wheels, as one that counts in "
           "degrees; set imu.units in the robot file";
  if (trust_.verdict() == Verdict::kOpposite)
    return "the IMU measures turns opposite to the wheels', as one that is mounted upside down; "
           "correct its transform to the robot's base frame or imu.sensor_pose in the robot file";
  if (trust_.verdict() == Verdict::kUnrelated)
    return "the IMU does not measure the turns that the wheels measure, as one whose mount is "
           "another; correct its transform to the robot's base frame or imu.sensor_pose in the "
           "robot file";
  return "";
}

Counters WheelImuOdometry::counters() const {
  auto all = wheels_->counters();
  all.add(counters_);
  return all;
}

std::uint64_t WheelImuOdometry::dropped() const {
  return wheels_->dropped() + counters_["gyro_late"] + counters_["gyro_stamp_jump"];
}

Component::Figures WheelImuOdometry::figures() const {
  return {{"gyro_bias", calibration_.bias()},
          {"gyro_bias_sigma", std::sqrt(calibration_.biasVariance())},
          {"gyro_noise", std::sqrt(calibration_.noiseVariance())}};
}

void WheelImuOdometry::saveState(ArchiveWriter& archive) const { archive(*this); }

void WheelImuOdometry::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::imu_odometry
