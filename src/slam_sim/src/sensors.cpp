// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/sensors.hpp"

#include <utility>

namespace slam::sim {
namespace {

/// The random streams of the sensors.
constexpr std::uint32_t kWheels = 1, kLaser = 2, kImu = 3, kRearLaser = 4, kCommands = 5;
constexpr std::uint32_t kFirstCamera = 16;

Eigen::Isometry3d spatial(const Pose2& pose) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().head<2>() = pose.position();
  T.linear().topLeftCorner<2, 2>() = pose.rotation();
  return T;
}

}  // namespace

Sensors::Sensors(const World& world, RobotModel robot, std::uint64_t seed)
    : world_(world),
      robot_(std::move(robot)),
      seed_(seed),
      plan_(world),
      laser_(plan_, robot_.laser),
      rear_laser_(plan_, robot_.rear_laser.value_or(LaserModel())) {}

void Sensors::openCamera(std::size_t camera) {
  if (!scene_) scene_ = std::make_shared<const Scene>(world_);
  const auto& model = robot_.cameras.at(camera);
  cameras_.try_emplace(camera, scene_, model.calibration, model.optics);
}

RandomStream Sensors::wheelNoise(std::uint64_t reading) const {
  return RandomStream(seed_, reading, kWheels);
}

RandomStream Sensors::imuNoise(std::uint64_t reading) const {
  return RandomStream(seed_, reading, kImu);
}

RandomStream Sensors::commandNoise(std::uint64_t reading) const {
  return RandomStream(seed_, reading, kCommands);
}

LaserReadings Sensors::scan(const Pose2& T_world_base, std::uint64_t reading) const {
  RandomStream random(seed_, reading, kLaser);
  return laser_.scan(T_world_base, random);
}

LaserReadings Sensors::rearScan(const Pose2& T_world_base, std::uint64_t reading) const {
  RandomStream random(seed_, reading, kRearLaser);
  return rear_laser_.scan(T_world_base, random);
}

cv::Mat Sensors::image(std::size_t camera, const BasePath& T_world_base, std::uint64_t reading,
                       double time) const {
  const auto& model = robot_.cameras.at(camera);
  const Eigen::Isometry3d T_base_camera = model.T_base_optical();
  const auto path = [&](double part) -> Eigen::Isometry3d {
    const double duration = model.optics.exposure + model.optics.rolling_shutter;
    return spatial(T_world_base((part - 0.5) * duration)) * T_base_camera;
  };
  return cameras_.at(camera).render(
      path, RandomStream(seed_, reading, kFirstCamera + static_cast<std::uint32_t>(camera)),
      world_.light.levelAt(time));
}

Duration timeOf(const Pace& pace, std::uint64_t reading) {
  return durationFromSeconds(pace.phase + static_cast<double>(reading) / pace.rate);
}

}  // namespace slam::sim
