// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <csignal>
#include <string>

#include "slam_core/common/folder_lock.hpp"
#include "slam_ros/ground_truth.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  const bool with_wheels = argc == 4 && argv[3] == std::string("--wheels");
  if (argc != 3 && !with_wheels) {
    fmt::print(stderr, "usage: slam_ground_truth X.bag FOLDER [--wheels]\n");
    return 2;
  }
  try {
    const slam_ros::BagReader bag(argv[1]);
    const slam::FolderLock lock(argv[2]);
    const auto counts = slam_ros::writeGroundTruth(bag, argv[2]);
    if (with_wheels) slam_ros::writeWheelOdometry(bag, argv[2]);
    fmt::print("{}: {} true poses, {} true landmarks\n", argv[2], counts.poses, counts.landmarks);
  } catch (const std::exception& error) {
    fmt::print(stderr, "slam_ground_truth: {}\n", error.what());
    return 1;
  }
  return 0;
}
