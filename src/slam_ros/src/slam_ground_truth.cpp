// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <string>

#include "slam_core/common/folder_lock.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/ground_truth.hpp"
#include "slam_ros/run_origin.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app(
      "Adds to the folder of a run what its bag knows better, and where the run comes from.",
      "slam_ground_truth");
  std::string file, folder, origin;
  bool with_wheels = false;
  app.add_option("BAG", file, "the bag of the run")->required();
  app.add_option("FOLDER", folder, "the run's files")->required();
  app.add_flag("--wheels", with_wheels, "write the odometry of the wheels as well");
  app.add_option("--origin", origin, "JSON that metrics.json and config.yaml get as `run`");
  return slam_ros::runProgram(app, argc, argv, [&] {
    const slam_ros::RunOrigin of_run(origin);
    const slam_ros::BagReader bag(file);
    const slam::FolderLock lock(folder);
    const auto counts = slam_ros::writeGroundTruth(bag, folder);
    if (with_wheels) slam_ros::writeWheelOdometry(bag, folder);
    of_run.addToFolder(folder);
    fmt::print("{}: {} true poses, {} true landmarks\n", folder, counts.poses, counts.landmarks);
  });
}
