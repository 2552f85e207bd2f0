// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <csignal>
#include <string>

#include "slam_core/common/folder_lock.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/ground_truth.hpp"
#include "slam_ros/run_origin.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  slam_ros::CommandLine line(
      "slam_ground_truth",
      "Adds to the folder of a run what its bag knows better, and where the run comes from.");
  std::string file, folder, origin;
  bool with_wheels = false;
  line.add("BAG", file, "the bag of the run").required();
  line.add("FOLDER", folder, "the run's files").required();
  line.add("--wheels", with_wheels, "write the odometry of the wheels as well");
  line.add("--origin", origin, "JSON that metrics.json and config.yaml get as `run`");
  return line.run(argc, argv, [&] {
    const slam_ros::RunOrigin of_run(origin);
    const slam_ros::BagReader bag(file);
    const slam::FolderLock lock(folder);
    const auto counts = slam_ros::writeGroundTruth(bag, folder);
    if (with_wheels) slam_ros::writeWheelOdometry(bag, folder);
    of_run.addToFolder(folder);
    fmt::print("{}: {} true poses, {} true landmarks\n", folder, counts.poses, counts.landmarks);
  });
}
