// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>

#include "cpu_time.hpp"
#include "odometry_drift.hpp"
#include "slam_core/camera/camera_gate.hpp"
#include "slam_core/common/progress.hpp"
#include "slam_core/visual_odometry/visual_odometry.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_sim/world_file.hpp"
#include "vo_scenarios.hpp"

// Visual odometry by itself on simulated drives: drift beside that of the wheels, whether its
// covariances are right, and the time of an image for each kind of features.

namespace slam::eval {
namespace {

struct Options {
  std::string world, robot, scenario = "drive";
  std::vector<std::string> features = {"orb", "klt", "akaze", "sift"};
  std::vector<std::string> overrides;
  std::uint64_t seed = 1;
  double ceiling_height = 1.7;
  std::size_t images = 0;
  bool track = false;
};

nlohmann::json toJson(const std::vector<Pose2>& poses) {
  auto array = nlohmann::json::array();
  for (const auto& pose : poses) array.push_back({pose.x(), pose.y(), pose.theta()});
  return array;
}

/// One kind of features on its way.
struct Contender {
  std::string features;
  CeilingCameraGate gate;
  std::unique_ptr<visual_odometry::VisualOdometry> odometry;
  OdometryTrack track;
  std::vector<double> times;

  void look(const Image& image, const Pose2& truth) {
    gate.set(image);
    gate.execute();
    odometry->set(gate.view().value());
    const double begin = cpuMilliseconds();
    odometry->execute();
    times.push_back(cpuMilliseconds() - begin);
    const auto& motion = odometry->motion();
    track.truth.push_back(truth);
    track.odometry.push_back(motion ? motion->odometry_end : Pose2());
    if (motion) track.motions.push_back(*motion);
  }

  nlohmann::json result() {
    std::sort(times.begin(), times.end());
    auto entry = driftOf(track);
    entry["features"] = features;
    entry["ms_p50"] = times[times.size() / 2];
    entry["ms_p99"] = times[times.size() * 99 / 100];
    entry["nees_1"] = normalisedError(track, 1);
    entry["nees_15"] = normalisedError(track, 15);
    entry["nees_100"] = normalisedError(track, 100);
    for (const auto& [reason, count] : odometry->counters().all()) entry["counted"][reason] = count;
    return entry;
  }
};

Contender makeContender(const std::string& features, const Options& options,
                        const sim::CameraModel& camera) {
  auto overrides = options.overrides;
  overrides.insert(overrides.begin(),
                   {"visual_odometry.features=" + features,
                    "visual_odometry.ceiling_height=" + std::to_string(options.ceiling_height)});
  Settings settings({"product", {}}, {"robot", {}}, overrides);
  Contender contender;
  contender.features = features;
  contender.odometry = std::make_unique<visual_odometry::VisualOdometry>();
  contender.odometry->configure(settings);
  contender.gate.configure(settings);
  settings.requireAllRead();
  contender.odometry->seed(options.seed);
  contender.gate.set(camera.calibration);
  contender.gate.set(CameraMount{camera.optical_frame, camera.T_base_optical()});
  return contender;
}

nlohmann::json run(const Options& options) {
  const auto world = sim::readWorldFile(options.world);
  const auto robot = sim::readRobotFile(options.robot);
  const auto index = cameraOf(robot, "ceiling_camera");
  const auto& camera = robot.cameras[index];
  const auto scenarios = scenariosOf(world, robot);
  const auto scenario = std::find_if(scenarios.begin(), scenarios.end(), [&](const auto& entry) {
    return entry.name == options.scenario;
  });
  if (scenario == scenarios.end())
    throw std::runtime_error("there is no scenario '" + options.scenario +
                             "'; there are: drive, turn, stand");
  sim::Sensors sensors(world, robot, options.seed);
  sensors.openCamera(index);
  std::vector<Contender> contenders;
  for (const auto& features : options.features)
    contenders.push_back(makeContender(features, options, camera));
  OdometryTrack wheels;
  sim::WheelOdometer odometer({robot.wheels, robot.noise});

  auto count = static_cast<std::uint64_t>(scenario->duration * camera.pace.rate);
  if (options.images > 0) count = std::min<std::uint64_t>(count, options.images);
  Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
  progress.begin("images", count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto at = sim::timeOf(camera.pace, i);
    const double t = seconds(at);
    const Pose2 truth = scenario->path(t);
    const auto around = [&](double s) { return scenario->path(t + s); };
    const Image image{Stamp(at), camera.optical_frame, sensors.image(index, around, i, t), ""};
    for (auto& contender : contenders) contender.look(image, truth);
    auto noise = sensors.wheelNoise(i);
    odometer.moveTo(truth, noise);
    wheels.truth.push_back(truth);
    wheels.odometry.push_back(odometer.pose());
    progress.update(i + 1);
  }
  progress.end();
  nlohmann::json result = {
      {"scenario", scenario->name}, {"images", count}, {"wheels", driftOf(wheels)}};
  for (auto& contender : contenders) {
    result["visual"].push_back(contender.result());
    if (options.track) result["visual"].back()["track"] = toJson(contender.track.odometry);
  }
  if (options.track) {
    result["truth"] = toJson(wheels.truth);
    result["wheels"]["track"] = toJson(wheels.odometry);
  }
  return result;
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_eval_vo", "Drift, covariances and speed of visual odometry on a simulated drive");
  slam::eval::Options options;
  line.add("--world", options.world, "world file").existingFile().required();
  line.add("--robot", options.robot, "robot file").existingFile().required();
  line.add("--scenario", options.scenario, "drive, turn (on the spot), stand (a minute)")
      .withDefault();
  line.add("--features", options.features, "kinds of features, all on the same images")
      .withDefault();
  line.add("--seed", options.seed, "of noise and of RANSAC").withDefault();
  line.add("--ceiling-height", options.ceiling_height, "above the camera, as told [m]")
      .withDefault();
  line.add("--images", options.images, "no more than these; 0: all").withDefault();
  line.add("--track", options.track, "the paths as well");
  line.add("--set", options.overrides, "SECTION.KEY=VALUE");
  return line.run(argc, argv, [&] {
    cv::setNumThreads(1);
    std::puts(slam::eval::run(options).dump(1).c_str());
  });
}
