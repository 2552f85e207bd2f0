// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "cpu_time.hpp"
#include "odometry_drift.hpp"
#include "slam_core/common/progress.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/laser/scan_gate.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_sim/drive.hpp"
#include "slam_sim/sensors.hpp"
#include "slam_sim/world_file.hpp"

// Laser odometry by itself on a simulated drive: the time of a scan, drift, and whether its
// covariances are right; without wheels and with them.

namespace slam::eval {
namespace {

struct Options {
  std::string world, robot;
  std::vector<std::string> overrides;
  std::uint64_t seed = 1;
  double rate = 40.0;     ///< of the laser [Hz]
  double duration = 1e9;  ///< [s], at most
};

/// One odometry on its way.
class Contender {
 public:
  Contender(const std::string& name, Settings& settings)
      : odometry_(Registry<OdometrySource>::instance().create(name)), ports_(portsOf(*odometry_)) {
    odometry_->configure(settings);
  }

  void take(const LaserScan& scan, const OdometrySample& wheels, const Pose2& truth) {
    const double begin = cpuMilliseconds();
    give(wheels);
    execute();
    give(scan);
    execute();
    times_.push_back(cpuMilliseconds() - begin);
    track_.truth.push_back(truth);
    track_.odometry.push_back(track_.motions.empty() ? Pose2()
                                                     : track_.motions.back().odometry_end);
  }

  nlohmann::json result(const std::string& name) {
    std::sort(times_.begin(), times_.end());
    auto entry = driftOf(track_);
    entry["name"] = name;
    entry["ms_mean"] =
        std::accumulate(times_.begin(), times_.end(), 0.0) / static_cast<double>(times_.size());
    entry["ms_p99"] = times_[times_.size() * 99 / 100];
    entry["ms_max"] = times_.back();
    if (track_.motions.size() + 1 == track_.truth.size())
      entry["nees"] = 3.0 * normalisedError(track_, 1);
    return entry;
  }

 private:
  /// A value for the inputs of its kind.
  template <class T>
  void give(const T& value) {
    for (const auto& input : ports_.inputs())
      if (input.kind == kindOf<T>()) input.set(&value);
  }

  void execute() {
    do {
      odometry_->execute();
      if (odometry_->motion()) track_.motions.push_back(*odometry_->motion());
    } while (odometry_->isBusy());
  }

  std::unique_ptr<OdometrySource> odometry_;
  Ports ports_;
  OdometryTrack track_;
  std::vector<double> times_;
};

LaserSweep sweepOf(const sim::LaserModel& laser, Stamp stamp, std::vector<float> ranges) {
  LaserSweep sweep;
  sweep.stamp = stamp;
  sweep.frame = laser.frame;
  sweep.angle_min = static_cast<float>(laser.angle(0));
  sweep.angle_max = static_cast<float>(laser.angle(laser.beams - 1));
  sweep.angle_increment = static_cast<float>(laser.increment());
  sweep.range_min = static_cast<float>(laser.min_range);
  sweep.range_max = static_cast<float>(laser.max_range);
  sweep.ranges = std::move(ranges);
  return sweep;
}

LaserMount mountOf(const sim::LaserModel& laser) {
  LaserMount mount{laser.frame, Eigen::Isometry3d::Identity()};
  mount.T_base_laser.translate(laser.position);
  mount.T_base_laser.rotate(Eigen::AngleAxisd(laser.yaw, Eigen::Vector3d::UnitZ()));
  return mount;
}

nlohmann::json run(const Options& options) {
  const auto world = sim::readWorldFile(options.world);
  auto robot = sim::readRobotFile(options.robot);
  robot.laser.pace.rate = options.rate;
  const sim::Drive drive(world.path, robot);
  const sim::Sensors sensors(world, robot, options.seed);
  Settings settings({"product", {}}, {"robot", {}}, options.overrides);
  loadLibraries({});
  ScanGate gate;
  gate.configure(settings);
  gate.set(mountOf(robot.laser));
  Contender laser("laser", settings);
  Contender with_wheels("laser_wheel", settings);
  settings.requireAllRead();
  sim::WheelOdometer odometer({robot.wheels, robot.noise});

  const double duration = std::min(options.duration, drive.duration());
  const auto count = static_cast<std::uint64_t>(duration * options.rate);
  Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
  progress.begin("scans", count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto at = sim::timeOf(robot.laser.pace, i);
    const Pose2 truth = drive.pose(seconds(at));
    auto noise = sensors.wheelNoise(i);
    odometer.moveTo(truth, noise);
    OdometrySample wheels;
    wheels.stamp = Stamp(at);
    wheels.pose = odometer.pose();
    gate.set(sweepOf(robot.laser, Stamp(at), sensors.scan(truth, i).ranges));
    gate.execute();
    laser.take(gate.scan().value(), wheels, truth);
    with_wheels.take(gate.scan().value(), wheels, truth);
    progress.update(i + 1);
  }
  progress.end();
  return {{"world", world.name},
          {"scans", count},
          {"beams", robot.laser.beams},
          {"rate", options.rate},
          {"odometry", {laser.result("laser"), with_wheels.result("laser_wheel")}}};
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line("slam_eval_laser_odometry",
                             "Time, drift and covariances of laser odometry on a simulated drive");
  slam::eval::Options options;
  line.add("--world", options.world, "world file").existingFile().required();
  line.add("--robot", options.robot, "robot file").existingFile().required();
  line.add("--seed", options.seed, "of noise").withDefault();
  line.add("--rate", options.rate, "of the laser [Hz]").withDefault();
  line.add("--duration", options.duration, "at most [s]");
  line.add("--set", options.overrides, "SECTION.KEY=VALUE");
  return line.run(argc, argv, [&] { std::puts(slam::eval::run(options).dump(1).c_str()); });
}
