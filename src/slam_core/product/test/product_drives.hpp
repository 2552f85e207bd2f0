// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "slam_core/imu/imu_reading.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/models/velocity_command.hpp"
#include "slam_core/product/meta_coordinator.hpp"

namespace slam::test {

/// Gives a product what one sensor said.
using ProductInput = std::function<void(MetaCoordinator& product)>;

inline OdometrySample odometryAt(Stamp stamp, const Pose2& pose) {
  OdometrySample sample;
  sample.stamp = stamp;
  sample.pose = pose;
  sample.odometry_frame = "odom";
  sample.base_frame = "base_link";
  return sample;
}

/// What the wheels and one sensor say on a drive; the wheels' data come up to three steps late, so
/// that steps wait for them.
class LateWheels {
 public:
  explicit LateWheels(std::uint64_t seed) : random_(seed, 1) {}

  template <class T>
  void add(const Motion& motion, const char* port, const T& seen) {
    if (inputs_.empty()) give("odom", odometryAt(motion.start, motion.odometry_start));
    late_.push_back(odometryAt(motion.end, motion.odometry_end));
    give(port, seen);
    while (late_.size() > 3 || (!late_.empty() && random_.uniform() < 0.6)) {
      give("odom", late_.front());
      late_.pop_front();
    }
  }
  template <class T>
  void give(const char* port, const T& value) {
    inputs_.push_back([port, value](MetaCoordinator& product) { product.put(port, value); });
  }
  std::vector<ProductInput> take() { return std::move(inputs_); }

 private:
  RandomStream random_;
  std::deque<OdometrySample> late_;
  std::vector<ProductInput> inputs_;
};

/// A drive of more than a lap between landmarks; some observations are of none.
inline std::vector<ProductInput> landmarkInputs(std::uint64_t seed) {
  LateWheels drive(seed);
  SimulatedWorld world(seed);
  RandomStream random(seed, 2);
  for (int i = 0; i < 160; ++i) {
    auto step = world.next();
    for (auto& z : step.observations.observations)
      if (random.uniform() < 0.05) z.range += 1.0 + random.uniform();
    drive.add(step.motion, "observations", step.observations);
  }
  return drive.take();
}

/// An IMU that hangs upside down; its mount comes after the first readings.
class HangingImu {
 public:
  explicit HangingImu(std::uint64_t seed) : random_(seed, 2) {}

  void measure(const Motion& motion, LateWheels& drive) {
    constexpr int kReadings = 5;  // in a motion
    ImuReading reading;
    reading.frame = "imu_link";
    const auto interval = motion.end - motion.start;
    const double rate = motion.increment.theta() / seconds(interval);
    for (int k = 0; k < kReadings; ++k) {
      reading.stamp = motion.start + k * interval / kReadings;
      reading.angular_velocity.z() = -rate + 0.01 + 0.002 * random_.gaussian();
      drive.give("imu", reading);
    }
    const Eigen::AngleAxisd upside_down(M_PI, Eigen::Vector3d::UnitX());
    if (++motions_ == 4) drive.give("imu", ImuMount{"imu_link", Eigen::Isometry3d(upside_down)});
  }

 private:
  RandomStream random_;
  int motions_ = 0;
};

/// The same with an IMU.
inline std::vector<ProductInput> gyroInputs(std::uint64_t seed) {
  LateWheels drive(seed);
  SimulatedWorld world(seed);
  HangingImu imu(seed);
  for (int i = 0; i < 160; ++i) {
    const auto step = world.next();
    imu.measure(step.motion, drive);
    drive.add(step.motion, "observations", step.observations);
  }
  return drive.take();
}

/// The same with commands, and a pause of six seconds in which none comes.
inline std::vector<ProductInput> commandInputs(std::uint64_t seed) {
  LateWheels drive(seed);
  SimulatedWorld world(seed);
  Duration paused{};
  for (int i = 0; i < 160; ++i) {
    auto step = world.next();
    if (i == 80) paused = std::chrono::seconds(6);
    const double interval = seconds(step.motion.end - step.motion.start);
    const VelocityCommand command{step.motion.start + paused,
                                  step.motion.increment.log() / interval};
    step.observations.stamp += paused;
    drive.give("observations", step.observations);
    drive.give("commands", command);
  }
  return drive.take();
}

/// The robot is carried half round the circle, which its wheels do not notice.
inline std::vector<ProductInput> carriedInputs(std::uint64_t seed) {
  constexpr int kFirst = 130, kCarried = 60, kLast = 60;
  LateWheels drive(seed);
  SimulatedWorld world(seed);
  Pose2 before, carried;  // odometry where it is carried from, and by how much
  for (int i = 0; i < kFirst + kCarried + kLast; ++i) {
    auto step = world.next();
    if (i == kFirst) before = step.motion.odometry_start;
    if (i >= kFirst && i < kFirst + kCarried) {
      carried = before * step.motion.odometry_end.inverse();
      continue;
    }
    if (i >= kFirst) {
      const auto time = kCarried * std::chrono::milliseconds(100);
      step.motion.start -= time;
      step.motion.end -= time;
      step.motion.odometry_start = carried * step.motion.odometry_start;
      step.motion.odometry_end = carried * step.motion.odometry_end;
      step.observations.stamp -= time;
      step.observations.sequence -= kCarried;
    }
    drive.add(step.motion, "observations", step.observations);
  }
  return drive.take();
}

/// A laser's sweep of which a gate makes this scan.
inline LaserSweep sweepOf(const LaserScan& scan) {
  LaserSweep sweep;
  sweep.stamp = scan.stamp;
  sweep.frame = scan.sensor_frame;
  sweep.angle_min = scan.beams.front().bearing;
  sweep.angle_max = scan.beams.back().bearing;
  sweep.angle_increment =
      (sweep.angle_max - sweep.angle_min) / static_cast<float>(scan.beams.size() - 1);
  sweep.range_max = 8.0f;
  for (const auto& beam : scan.beams) sweep.ranges.push_back(beam.hit ? beam.range : INFINITY);
  return sweep;
}

/// A drive round a room; the laser's mount comes after the first sweeps. @param imu beside it
inline std::vector<ProductInput> scanInputs(std::uint64_t seed, int steps,
                                            std::optional<HangingImu> imu = std::nullopt) {
  LateWheels drive(seed);
  RoomDrive world(seed);
  Pose2 odometry;
  for (int i = 0; i < steps; ++i) {
    auto step = world.next();
    auto& motion = step.motion;
    motion.odometry_start = odometry;
    odometry = motion.odometry_end = odometry * motion.increment;
    if (imu) imu->measure(motion, drive);
    drive.add(motion, "scan", sweepOf(step.scan));
    if (i != 3) continue;
    LaserMount mount{"laser", Eigen::Isometry3d::Identity()};
    const auto& pose = step.scan.sensor_pose;
    mount.T_base_laser.translation() << pose.x(), pose.y(), 0.3;
    mount.T_base_laser.rotate(Eigen::AngleAxisd(pose.theta(), Eigen::Vector3d::UnitZ()));
    drive.give("scan", mount);
  }
  return drive.take();
}

}  // namespace slam::test
