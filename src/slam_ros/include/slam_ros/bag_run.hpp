// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/common/settings.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_reader.hpp"
#include "slam_ros/run_metrics.hpp"
#include "slam_ros/run_origin.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

// Programs that run a product on a bag share this, whatever runs its components.

/// The options of each such program.
struct BagRunOptions {
  std::string product;  ///< file or name
  std::string robot;    ///< file or name; empty: the bag names it
  std::string bag, folder;
  std::vector<std::string> overrides, remaps;
  RunOrigin origin = {};  ///< goes into metrics.json and config.yaml
};

/// @return the robot's name or file @throw UnknownName if neither options nor bag name it
std::string robotOf(const BagRunOptions& options, const BagReader& bag);
/// Reads the files of product and robot. @throw UnknownName, slam::ConfigError
slam::Settings settingsFor(const BagRunOptions& options, const BagReader& bag);
/// Configures a product, and checks that topics can bring what it takes in. @throw
/// slam::ConfigError
TopicsConfig configured(slam::Settings& settings, slam::MetaCoordinator& product);

/// Refuses a run in which no step was taken, or in which no sensor other than the odometry could be
/// used: its path would be that of the odometry alone.
/// @param poses of the run
/// @param counters are printed where the run is refused, since they may tell why
/// @throw std::runtime_error with what was missing
void requireSteps(const RunMetrics& metrics, std::size_t poses, const BagInputs& inputs,
                  const BagReader& bag, const slam::Counters& counters);

/// The data of a run that had no effect.
struct UnusedData {
  std::uint64_t dropped = 0, messages = 0;  ///< of so many messages
  std::uint64_t set_aside = 0;  ///< their stamps are from before those of messages before them
  slam::Counters held;          ///< no step was taken for them, by what they are
  std::string starving;         ///< as slam::Intake::Arrivals has it
};

/// @return a sentence for each kind of unused data that is worth a warning
std::vector<std::string> sentencesOn(const UnusedData& unused);

/// The run began again, since the stamps of the bag went back.
constexpr const char* kStampsWentBack =
    "the stamps went back: map and pose begin anew; what was written until then is kept in files "
    "named ...before_restart_...";

/// Prints all counters on one line; nothing if nothing was counted.
void printCounts(const slam::Counters& counters);

}  // namespace slam_ros
