// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/package.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
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

constexpr int kFailed = 1, kWrongUse = 2, kInterrupted = 130;

std::atomic<bool> stop{false};

struct Options {
  std::string bag, world = "office", robot = "segway";
  slam::sim::RecordingOptions recording;
};

/// A word on the command line that stands for nothing.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

int fail(const std::string& sentence, int code) {
  std::cerr << "slam_sim: " << sentence << std::endl;
  return code;
}

std::string faultOfDuration(const std::string& text) {
  double seconds = 0.0;
  if (CLI::detail::lexical_cast(text, seconds) && std::isfinite(seconds) && seconds > 0.0)
    return "";
  return "'" + text + "' is no number of seconds above 0";
}

/// Else a sign would make a large number of it.
std::string faultOfSeed(const std::string& text) {
  return text.empty() || text[0] != '-' ? "" : "'" + text + "' is below 0";
}

void addOptions(CLI::App& app, Options& options) {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  auto& recording = options.recording;
  recording.threads = cores;
  app.add_option("OUT.bag", options.bag, "the bag to write")->required();
  app.add_option("--world", options.world,
                 "office, corridor, hall, depot, forest, foyer, gallery, loops or a file.yaml")
      ->capture_default_str();
  app.add_option("--robot", options.robot,
                 "segway, omni, skid, scout, car, turtlebot3 or a file.yaml")
      ->capture_default_str();
  app.add_option("--seed", recording.seed, "of all noise")
      ->check(faultOfSeed)
      ->capture_default_str();
  app.add_option("--only", recording.streams,
                 "odom,scan,imu,camera,rear_camera,ceiling_camera: some of them")
      ->delimiter(',');
  app.add_option("--duration", recording.duration, "the drive's first seconds only [s]")
      ->check(faultOfDuration);
  app.add_option("--threads", recording.threads, "that render; the bag is the same")
      ->check(CLI::Range(1u, 256u))
      ->capture_default_str();
}

std::string fileOf(const std::string& folder, const std::string& kind, const std::string& name) {
  return slam_ros::findConfigFile(ros::package::getPath("slam_sim") + "/" + folder, kind, name);
}

void checkStreams(const std::vector<std::string>& wanted, const RobotModel& robot) {
  const auto known = slam::sim::streamNames(robot);
  for (const auto& name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError("--only: there is no '" + name + "'" + slam::didYouMean(name, known) +
                       "; there are: " + slam::join(known));
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
  CLI::App app("Simulates a robot's drive and writes what its sensors say as a bag.", "slam_sim");
  Options options;
  addOptions(app, options);
  try {
    app.parse(argc, argv);
    run(options);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(slam_ros::sentenceOf(app, error), kWrongUse);
  } catch (const slam_ros::UnknownName& error) {
    return fail(error.what(), kWrongUse);
  } catch (const UsageError& error) {
    return fail(error.what(), kWrongUse);
  } catch (const slam_ros::BagPathError& error) {
    return fail(error.what(), kWrongUse);
  } catch (const slam::sim::Interrupted& error) {
    return fail(error.what(), kInterrupted);
  } catch (const std::exception& error) {
    return fail(error.what(), kFailed);
  }
  return 0;
}
