// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <set>

#include "slam_core/common/settings.hpp"
#include "slam_sim/robot_model.hpp"
#include "yaml_map.hpp"

namespace slam::sim {
namespace {

constexpr int kRobotVersion = 1;
const Range kNotNegative = Range::atLeast(0.0);
const Range kScale = Range::open(0.5, 2.0);

Eigen::Isometry3d poseOf(const std::vector<double>& p) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Vector3d(p[0], p[1], p[2]);
  T.linear() = (Eigen::AngleAxisd(p[5], Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(p[4], Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(p[3], Eigen::Vector3d::UnitX()))
                   .toRotationMatrix();
  return T;
}

void readVersion(YamlMap& root) {
  int version = kRobotVersion;
  root.require("version", version);
  if (version != kRobotVersion)
    root.fault("has version " + std::to_string(version) + "; this program reads version " +
               std::to_string(kRobotVersion));
}

void readPace(YamlMap& map, Pace& pace) {
  map.read("rate", pace.rate, Range::closed(0.1, 1000.0));
  map.read("phase", pace.phase, kNotNegative);
}

void readWheels(YamlMap map, RobotModel& robot) {
  auto& wheels = robot.wheels;
  map.read("drive", wheels.drive, {"differential", "omnidirectional"});
  robot.noise.omnidirectional = wheels.drive == "omnidirectional";
  const std::size_t count = robot.noise.omnidirectional ? 4 : 2;
  wheels.wheel_scales.assign(count, 1.0);
  map.require("lever", wheels.lever, kPositive);
  map.read("lever_scale", wheels.lever_scale, kScale);
  map.read("wheel_scales", wheels.wheel_scales, kScale);
  map.finish();
  if (wheels.wheel_scales.size() != count)
    map.fault("needs " + std::to_string(count) + " wheel_scales, not " +
              std::to_string(wheels.wheel_scales.size()));
}

void readOdometry(YamlMap map, RobotModel& robot) {
  readPace(map, robot.odometry);
  map.read("frame", robot.odom_frame);
  map.read("alpha1", robot.noise.alpha1, kNotNegative);
  map.read("alpha2", robot.noise.alpha2, kNotNegative);
  map.read("alpha3", robot.noise.alpha3, kNotNegative);
  map.read("alpha4", robot.noise.alpha4, kNotNegative);
  map.finish();
}

void readLimits(YamlMap map, DriveLimits& limits) {
  map.read("speed", limits.speed, kPositive);
  map.read("acceleration", limits.acceleration, kPositive);
  map.read("lateral_acceleration", limits.lateral_acceleration, kPositive);
  map.read("turn_rate", limits.turn_rate, kPositive);
  map.read("turn_acceleration", limits.turn_acceleration, kPositive);
  map.finish();
}

void readLaser(YamlMap map, LaserModel& laser) {
  readPace(map, laser.pace);
  map.read("frame", laser.frame);
  map.require("position", laser.position);
  map.read("yaw", laser.yaw);
  map.read("beams", laser.beams, Range::closed(2.0, 100000.0));
  map.read("field_of_view", laser.field_of_view, Range::closed(0.01, 6.2832));
  map.read("min_range", laser.min_range, kNotNegative);
  map.read("max_range", laser.max_range, kPositive);
  map.read("relative_noise", laser.relative_noise, kNotNegative);
  map.finish();
}

/// The transform that x y z [m] roll pitch yaw [rad] give; another number of values is a fault.
Eigen::Isometry3d readPose(YamlMap& map) {
  std::vector<double> pose(6, 0.0);
  map.require("pose", pose);
  if (pose.size() == 6) return poseOf(pose);
  map.fault("needs a pose of 6 numbers: x y z [m] roll pitch yaw [rad]");
  return Eigen::Isometry3d::Identity();
}

ImuModel readImu(YamlMap map) {
  ImuModel imu;
  map.read("frame", imu.frame);
  imu.T_base_imu = readPose(map);
  readPace(map, imu.pace);
  map.read("gyro_bias", imu.gyro_bias, Range::closed(-1.0, 1.0));
  map.read("gyro_bias_random_walk", imu.gyro_bias_random_walk, kNotNegative);
  map.read("gyro_noise", imu.gyro_noise, kNotNegative);
  map.read("gyro_scale", imu.gyro_scale, kScale);
  map.finish();
  return imu;
}

CommandModel readCommands(YamlMap map) {
  CommandModel commands;
  readPace(map, commands.pace);
  map.read("time_constant", commands.time_constant, kNotNegative);
  map.read("speed_scale", commands.speed_scale, kScale);
  map.read("turn_scale", commands.turn_scale, kScale);
  map.read("relative_noise", commands.relative_noise, kNotNegative);
  map.finish();
  return commands;
}

void readOptics(YamlMap map, CameraOptics& optics) {
  map.read("exposure", optics.exposure, kNotNegative);
  map.read("rolling_shutter", optics.rolling_shutter, kNotNegative);
  map.read("brightness", optics.brightness, kPositive);
  map.read("vignetting", optics.vignetting, Range::closed(0.0, 1.0));
  map.read("defocus_sigma", optics.defocus_sigma, kNotNegative);
  map.read("noise_sigma", optics.noise_sigma, kNotNegative);
  map.read("samples", optics.samples, Range::closed(1.0, 64.0));
  map.finish();
}

void readCalibration(YamlMap map, CameraCalibration& calibration) {
  map.require("width", calibration.width, Range::closed(16.0, 8192.0));
  map.require("height", calibration.height, Range::closed(16.0, 8192.0));
  map.require("fx", calibration.fx, kPositive);
  map.require("fy", calibration.fy, kPositive);
  map.require("cx", calibration.cx);
  map.require("cy", calibration.cy);
  map.read("distortion_model", calibration.distortion_model);
  map.read("distortion", calibration.distortion);
  map.finish();
  const auto fault = faultOf(calibration);
  if (!fault.empty()) map.fault(": " + fault);
}

CameraModel readCamera(YamlMap& map) {
  CameraModel camera;
  map.require("name", camera.name);
  camera.link_frame = camera.name + "_link";
  camera.optical_frame = camera.name + "_optical_frame";
  map.read("link_frame", camera.link_frame);
  map.read("optical_frame", camera.optical_frame);
  camera.T_base_link = readPose(map);
  readPace(map, camera.pace);
  readCalibration(map.map("calibration"), camera.calibration);
  readOptics(map.map("optics"), camera.optics);
  map.finish();
  const bool rolls = camera.optics.rolling_shutter > 0.0;
  if ((camera.optics.exposure + camera.optics.rolling_shutter) * camera.pace.rate > 1.0)
    map.fault(std::string("exposes ") + (rolls ? "and reads its rows " : "") +
              "longer than there is time between two images");
  return camera;
}

void checkNames(const RobotModel& robot, YamlMap& root) {
  if (robot.rear_laser && robot.rear_laser->frame == robot.laser.frame)
    root.fault("has two lasers of frame " + robot.laser.frame);
  std::set<std::string> names;
  for (const auto& camera : robot.cameras)
    if (!names.insert(camera.name).second) root.fault("has two cameras named " + camera.name);
  if (robot.heading_sway != 0.0 && !robot.noise.omnidirectional)
    root.fault("heading_sway: a differential base cannot drive sideways; it must be 0");
}

}  // namespace

Eigen::Isometry3d CameraModel::linkToOptical() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return T;
}

RobotModel readRobotFile(const std::string& path) {
  FaultCollector faults;
  const auto document = loadConfigFile(path);
  YamlMap root(path, "", document.root, faults);
  faults.raise();
  RobotModel robot;
  readVersion(root);
  root.require("robot", robot.name);
  root.read("base_frame", robot.base_frame);
  root.read("radius", robot.radius, kPositive);
  root.read("heading_sway", robot.heading_sway, Range::closed(0.0, 1.5));
  readWheels(root.map("wheels"), robot);
  readOdometry(root.map("odometry"), robot);
  readLimits(root.map("limits"), robot.limits);
  readLaser(root.map("laser"), robot.laser);
  if (root.has("rear_laser")) readLaser(root.map("rear_laser"), robot.rear_laser.emplace());
  if (root.has("imu")) robot.imu = readImu(root.map("imu"));
  if (root.has("commands")) robot.commands = readCommands(root.map("commands"));
  for (auto& camera : root.list("cameras")) robot.cameras.push_back(readCamera(camera));
  checkNames(robot, root);
  root.finish();
  faults.raise();
  return robot;
}

}  // namespace slam::sim
