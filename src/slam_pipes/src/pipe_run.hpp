// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "piped_product.hpp"
#include "slam_core/common/progress.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_run.hpp"
#include "slam_ros/run_metrics.hpp"
#include "slam_ros/warning_log.hpp"

namespace slam_pipes {

/// The options of `slam_pipes`.
struct RunOptions : slam_ros::BagRunOptions {
  std::string program;  ///< slam_part
};

/// Drives a product, each component of it a process, from a bag, and writes the run's folder: the
/// same files as slam_ros::OfflineRun, byte for byte but for what they say of time. Only this
/// process knows bags, and so ROS.
class PipeRun {
 public:
  /// Reads the configuration and finds the inputs; no process is started and nothing written yet.
  /// @throw std::exception with a sentence
  explicit PipeRun(const RunOptions& options);

  /// @throw std::exception with a sentence; also when no step could be taken
  void run();

 private:
  void configure();
  void choosePartsToStart();
  bool comes(const slam::InputPort& input) const;
  PipedProduct& processes();
  void read();
  slam_ros::BagSinks sinksOf(const slam_ros::BagInputs::Found& input);
  void takeStep(const StepDone& step);
  void complete(const std::vector<PartSummary>& summaries);
  const PartSummary& ofBackend(const std::vector<PartSummary>& summaries) const;
  std::uint64_t dropped(const std::vector<PartSummary>& summaries) const;
  void tellOfUnused(const std::vector<PartSummary>& summaries);
  slam::Counters counters(const std::vector<PartSummary>& summaries) const;
  void printSummary(const std::vector<PartSummary>& summaries) const;
  void warn(const std::string& sentence, bool is_urgent = false);

  RunOptions options_;
  slam_ros::RunMetrics metrics_;
  slam::Progress progress_;
  slam_ros::BagReader bag_;
  std::string product_file_, robot_file_;
  slam::Settings settings_;
  slam::MetaCoordinator whole_;  ///< checks the configuration, and gets no data
  std::optional<slam_ros::BagInputs> inputs_;
  std::vector<PartPorts> parts_;  ///< those that are started
  std::optional<PipedProduct> processes_;
  slam::Counters input_counters_;  ///< of the messages before they are data
  slam_ros::WarningLog warnings_;
  std::size_t messages_ = 0;
};

}  // namespace slam_pipes
