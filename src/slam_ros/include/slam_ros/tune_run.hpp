// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/tuning/noise_tuner.hpp"

namespace slam_ros {

/// The options of `slam_tune`.
struct TuneOptions {
  std::string robot;  ///< file or name
  std::string product = "ekf_wheel";
  std::vector<std::string> bags;
  std::string out;  ///< the robot file that is written
  std::vector<std::string> parameters, overrides, remaps;
};

/// The data that a bag has for a product: odometry or motion, and observations. If the bag has no
/// observations, the product's detector makes them from its images.
/// @throw std::exception with a sentence
slam::tuning::RecordedLog recordedLog(const TuneOptions& options, const std::string& bag);

/// Tunes, prints a table and writes the robot file.
/// @throw std::exception with a sentence
void tune(const TuneOptions& options);

}  // namespace slam_ros
