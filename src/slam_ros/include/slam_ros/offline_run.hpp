// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>
#include <string>

#include "slam_core/common/progress.hpp"
#include "slam_core/product/autosave.hpp"
#include "slam_core/product/checkpoint.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/run_writer.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_run.hpp"
#include "slam_ros/run_metrics.hpp"
#include "slam_ros/warning_log.hpp"

namespace slam_ros {

/// The options of `slam_offline`.
struct OfflineOptions : BagRunOptions {
  std::string load_map;  ///< landmarks.yaml to start with; empty: none
  std::string load_session, save_session, merge_session;  ///< files; empty: none
  /// Interval of the checkpoints [s of stamps]; 0 for none. The default is none, or the interval of
  /// the resumed run.
  std::optional<double> autosave = std::nullopt;
  bool resumes = false;  ///< go on from the folder's checkpoint
  /// Called after each message; returns whether the run is to be saved and to end.
  std::function<bool()> is_stopped = [] { return false; };
};

/// Runs a product's components on a bag, in one thread, as fast as possible, and writes the run's
/// folder.
class OfflineRun {
 public:
  /// Reads the configuration and finds the inputs; nothing is written yet.
  /// @throw std::exception with a sentence
  explicit OfflineRun(const OfflineOptions& options);

  /// @throw std::exception with a sentence; also when no step could be taken
  void run();

 private:
  void configure();
  void loadMap();
  void loadSession();
  void mergeSession();
  std::string session() const;
  void requireSession() const;
  void resume(slam::RunWriter& writer);
  void read(slam::RunWriter& writer);
  BagHandlers handlers();
  BagSinks sinksOf(const BagInputs::Found& input);
  void drain(slam::RunWriter& writer);
  slam::RunIdentity identity() const;
  void save(slam::RunWriter& writer);
  void stop(slam::RunWriter& writer);
  bool isResuming() const { return messages_ < resumed_; }
  void tellOfUnused();
  void warnOfNoCorrection();
  void noteCorrection(const slam::StepReport& report);
  void warn(const std::string& sentence, bool is_urgent = false);
  std::string mapFrame() const;
  slam::Counters counters() const;
  void printSummary(const slam::RunWriter& writer) const;

  OfflineOptions options_;
  RunMetrics metrics_;
  slam::Progress progress_;
  BagReader bag_;
  slam::Settings settings_;
  slam::MetaCoordinator coordinator_;
  std::optional<BagInputs> inputs_;
  slam::Counters input_counters_;            ///< of messages before their conversion to data
  RunMetrics::Clock::time_point arrival_{};  ///< of the current message
  WarningLog warnings_;
  slam::Autosave autosave_;
  slam::Stamp last_step_;
  bool was_corrected_ = false;  ///< the pose, by anything that the sensors saw
  std::size_t messages_ = 0;    ///< that have been handled
  std::size_t resumed_ = 0;     ///< that had been handled when the run was saved
};

}  // namespace slam_ros
