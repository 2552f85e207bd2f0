// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/package.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <iostream>
#include <thread>

#include "recording.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/common/nearest_name.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/product_files.hpp"
#include "slam_sim/world_file.hpp"

namespace {

using slam::sim::RobotModel;

constexpr int kInterrupted = 130;

std::atomic<bool> stop{false};

struct Options {
  std::string bag, world = "office", robot = "segway";
  slam::sim::RecordingOptions recording;
};

void addOptions(slam_ros::CommandLine& line, Options& options) {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  auto& recording = options.recording;
  recording.threads = cores;
  line.add("OUT.bag", options.bag, "the bag to write").required();
  line.add("--world", options.world,
           "office, corridor, hall, depot, forest, foyer, gallery, loops or a file.yaml")
      .withDefault();
  line.add("--robot", options.robot,
           "segway, omni, skid, scout, twin, car, turtlebot3 or a file.yaml")
      .withDefault();
  line.add("--seed", recording.seed, "of all noise").withDefault();
  line.add("--only", recording.streams,
           "odom,scan,rear_scan,imu,commands,camera,rear_camera,ceiling_camera: some of them")
      .separatedBy(',');
  line.add("--duration", recording.duration, "the drive's first seconds only [s]").positive();
  line.add("--threads", recording.threads, "that render; the bag is the same")
      .between(1u, 256u)
      .withDefault();
}

std::string fileOf(const std::string& folder, const std::string& kind, const std::string& name) {
  return slam_ros::findConfigFile(ros::package::getPath("slam_sim") + "/" + folder, kind, name);
}

void checkStreams(const std::vector<std::string>& wanted, const RobotModel& robot) {
  const auto known = slam::sim::streamNames(robot);
  for (const auto& name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw slam_ros::WrongUse("--only: there is no '" + name + "'" +
                               slam::didYouMean(name, known) + "; there are: " + slam::join(known));
}

void run(const Options& options) {
  const auto world_file = fileOf("worlds", "world", options.world);
  const auto robot_file = fileOf("robots", "robot", options.robot);
  const auto robot = slam::sim::readRobotFile(robot_file);
  checkStreams(options.recording.streams, robot);
  slam::sim::Recording recording(slam::sim::readWorldFile(world_file), robot, options.recording);
  slam::Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
  recording.write(options.bag, progress, stop);
  std::printf("%s: %zu messages, %.1f s of a drive of %.1f m\n", options.bag.c_str(),
              recording.messages(), recording.duration(), recording.length());
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit then shows as a write error
  std::signal(SIGINT, [](int) { stop = true; });
  std::signal(SIGTERM, [](int) { stop = true; });
  slam_ros::CommandLine line("slam_sim",
                             "Simulates a robot's drive and writes what its sensors say as a bag.");
  Options options;
  addOptions(line, options);
  return line.run(argc, argv, [&] {
    try {
      run(options);
      return 0;
    } catch (const slam::sim::Interrupted& error) {
      std::cerr << "slam_sim: " << error.what() << std::endl;
      return kInterrupted;
    }
  });
}
