// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <csignal>

#include "slam_ros/ground_truth.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  if (argc != 3) {
    fmt::print(stderr, "usage: slam_ground_truth X.bag FOLDER\n");
    return 2;
  }
  try {
    const auto counts = slam_ros::writeGroundTruth(slam_ros::BagReader(argv[1]), argv[2]);
    fmt::print("{}: {} true poses, {} true landmarks\n", argv[2], counts.poses, counts.landmarks);
  } catch (const std::exception& error) {
    fmt::print(stderr, "slam_ground_truth: {}\n", error.what());
    return 1;
  }
  return 0;
}
