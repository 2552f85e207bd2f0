// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "odometry_drift.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/imu/imu_gate.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_sim/drive.hpp"
#include "slam_sim/gyroscope.hpp"
#include "slam_sim/sensors.hpp"
#include "slam_sim/world_file.hpp"

// Wheels, and wheels with an IMU, by themselves on a simulated drive: the drift of the heading, and
// whether the covariances are right.

namespace slam::eval {
namespace {

constexpr double kRest = 2.0;  // before the drive [s]

struct Options {
  std::string world, robot;
  std::vector<std::string> overrides;
  std::uint64_t seed = 1;
  double duration = 1e9;   ///< [s], at most
  double lever_scale = 0;  ///< of the wheels, instead of the robot's
};

/// One odometry on its way.
class Contender {
 public:
  Contender(const std::string& name, Settings& settings)
      : odometry_(Registry<OdometrySource>::instance().create(name)), ports_(portsOf(*odometry_)) {
    odometry_->configure(settings);
  }

  /// A value for the inputs of its kind.
  template <class T>
  void take(const T& value) {
    for (const auto& input : ports_.inputs())
      if (input.kind == kindOf<T>()) input.set(&value);
    do {
      odometry_->execute();
      if (odometry_->motion()) motions_.push_back(*odometry_->motion());
    } while (odometry_->isBusy());
  }

  /// @param truth at the stamps of the wheels
  nlohmann::json result(const std::string& name, const std::vector<Pose2>& truth) const {
    OdometryTrack track;
    track.motions = motions_;
    track.odometry = {Pose2()};
    for (const auto& motion : motions_)
      track.odometry.push_back(track.odometry.back() * motion.increment);
    const auto count = static_cast<std::ptrdiff_t>(track.odometry.size());
    track.truth.assign(truth.begin(), truth.begin() + count);
    auto entry = driftOf(track);
    entry["name"] = name;
    entry["nees"] = 3.0 * normalisedError(track, 1);
    entry["nees_of_pieces"] = 3.0 * normalisedError(track, kPiece);
    return entry;
  }

 private:
  static constexpr std::size_t kPiece = 100;  // motions

  std::unique_ptr<OdometrySource> odometry_;
  Ports ports_;
  std::vector<Motion> motions_;
};

/// What the robot's wheels and its IMU measure, in the order of stamps.
class Drive {
 public:
  explicit Drive(const Options& options)
      : world_(sim::readWorldFile(options.world)),
        robot_(robotOf(options)),
        path_(world_.path, robot_),
        sensors_(world_, robot_, options.seed),
        odometer_({robot_.wheels, robot_.noise}),
        gyro_(*robot_.imu),
        duration_(std::min(options.duration, path_.duration() + kRest)) {}

  template <class Wheels, class Imu>
  void run(Wheels onWheels, Imu onImu) {
    std::uint64_t wheels = 0, readings = 0;
    while (true) {
      const auto of_wheels = sim::timeOf(robot_.odometry, wheels);
      const auto of_imu = sim::timeOf(robot_.imu->pace, readings);
      if (seconds(std::min(of_wheels, of_imu)) > duration_) return;
      if (of_imu <= of_wheels)
        onImu(imu(of_imu, readings++));
      else
        onWheels(odometry(of_wheels, wheels++), truth(seconds(of_wheels)));
    }
  }

  const std::string& world() const { return world_.name; }
  ImuMount mount() const { return {robot_.imu->frame, robot_.imu->T_base_imu}; }

 private:
  static sim::RobotModel robotOf(const Options& options) {
    auto robot = sim::readRobotFile(options.robot);
    if (!robot.imu) throw std::runtime_error(options.robot + " has no IMU");
    if (options.lever_scale > 0.0) robot.wheels.lever_scale = options.lever_scale;
    return robot;
  }

  Pose2 truth(double time) const { return path_.pose(time - kRest); }

  OdometrySample odometry(Duration time, std::uint64_t reading) {
    auto noise = sensors_.wheelNoise(reading);
    odometer_.moveTo(truth(seconds(time)), noise);
    OdometrySample sample;
    sample.stamp = Stamp(time);
    sample.pose = odometer_.pose();
    return sample;
  }

  ImuReading imu(Duration time, std::uint64_t reading) {
    auto noise = sensors_.imuNoise(reading);
    const double now = seconds(time);
    ImuReading measured;
    measured.stamp = Stamp(time);
    measured.frame = robot_.imu->frame;
    measured.angular_velocity =
        gyro_.measure(sim::turnRate([&](double offset) { return truth(now + offset); }), noise);
    return measured;
  }

  sim::World world_;
  sim::RobotModel robot_;
  sim::Drive path_;
  sim::Sensors sensors_;
  sim::WheelOdometer odometer_;
  sim::Gyroscope gyro_;
  double duration_;
};

nlohmann::json run(const Options& options) {
  Settings settings({"product", {}}, {"robot", {}}, options.overrides);
  loadLibraries({});
  Drive drive(options);
  ImuGate gate;
  gate.configure(settings);
  gate.set(drive.mount());
  Contender wheels("wheel", settings), with_imu("wheel_imu", settings);
  settings.requireAllRead();
  std::vector<Pose2> truth;
  drive.run(
      [&](const OdometrySample& sample, const Pose2& pose) {
        truth.push_back(pose);
        wheels.take(sample);
        with_imu.take(sample);
      },
      [&](const ImuReading& reading) {
        gate.set(reading);
        gate.execute();
        with_imu.take(gate.sample().value());
      });
  return {{"world", drive.world()},
          {"odometry", {wheels.result("wheel", truth), with_imu.result("wheel_imu", truth)}}};
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line("slam_eval_imu_odometry",
                             "Drift and covariances of wheels with an IMU on a simulated drive");
  slam::eval::Options options;
  line.add("--world", options.world, "world file").existingFile().required();
  line.add("--robot", options.robot, "robot file").existingFile().required();
  line.add("--seed", options.seed, "of noise").withDefault();
  line.add("--duration", options.duration, "at most [s]");
  line.add("--lever-scale", options.lever_scale, "of the wheels: below 1 turns are too large");
  line.add("--set", options.overrides, "SECTION.KEY=VALUE");
  return line.run(argc, argv, [&] { std::puts(slam::eval::run(options).dump(1).c_str()); });
}
