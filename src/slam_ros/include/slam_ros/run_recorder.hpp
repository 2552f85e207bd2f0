// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "slam_core/common/settings.hpp"
#include "slam_core/product/run_writer.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/outputs_config.hpp"
#include "slam_ros/run_metrics.hpp"

namespace slam_ros {

/// Writes the files of a run: its folder (`output_dir`) and the map at exit (`save_on_exit`). A
/// full disk ends the recording, but not the robot's run.
class RunRecorder {
 public:
  /// @param settings of the run, all sections read
  /// @param robot_file text of the robot file
  /// @throw std::runtime_error if the folder cannot be made
  RunRecorder(OutputsConfig config, std::string map_frame, slam::Settings settings,
              std::string robot_file, Diagnostics& diagnostics);

  /// @param time that the step took
  void write(const slam::StepReport& report, RunMetrics::Clock::duration time);
  /// To be called when the run starts over. Its files start over as well, as in
  /// RunWriter::restart().
  void restart();
  /// Completes all files.
  void finish(const slam::Capabilities& backend, std::uint64_t dropped_messages);

  slam::Stamp lastStamp() const { return last_stamp_; }

 private:
  template <class Action>
  void attempt(Action&& action);

  OutputsConfig config_;
  std::string map_frame_;
  slam::Settings settings_;
  std::string robot_file_;
  Diagnostics& diagnostics_;
  std::unique_ptr<slam::RunWriter> writer_;
  std::optional<RunMetrics> metrics_;  ///< since the first step
  slam::Stamp first_stamp_, last_stamp_;
};

}  // namespace slam_ros
