// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/run_recorder.hpp"

#include <filesystem>
#include <utility>

#include "slam_core/product/landmark_file.hpp"

namespace slam_ros {

RunRecorder::RunRecorder(OutputsConfig config, std::string map_frame, std::string values_in_force,
                         Diagnostics& diagnostics)
    : config_(std::move(config)),
      map_frame_(std::move(map_frame)),
      values_in_force_(std::move(values_in_force)),
      diagnostics_(diagnostics) {
  if (!config_.output_dir.empty()) writer_ = std::make_unique<slam::RunWriter>(config_.output_dir);
  if (!config_.save_on_exit.empty()) std::filesystem::create_directories(config_.save_on_exit);
}

template <class Action>
void RunRecorder::attempt(Action&& action) {
  try {
    action();
  } catch (const std::exception& error) {
    diagnostics_.fail(error.what());
    writer_.reset();
  }
}

void RunRecorder::write(const slam::StepReport& report) {
  last_stamp_ = report.stamp;
  if (writer_) attempt([&] { writer_->write(report); });
}

void RunRecorder::restart() {
  if (writer_) attempt([&] { writer_ = std::make_unique<slam::RunWriter>(config_.output_dir); });
}

void RunRecorder::finish(const slam::Backend& backend) {
  if (writer_) attempt([&] { writer_->finish(backend, map_frame_, values_in_force_); });
  if (config_.save_on_exit.empty()) return;
  attempt([&] {
    slam::saveLandmarks(config_.save_on_exit + "/landmarks.yaml",
                        {map_frame_, last_stamp_, backend.state()});
  });
}

}  // namespace slam_ros
