// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/run_recorder.hpp"

#include <filesystem>
#include <utility>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/product/map_files.hpp"
#include "slam_core/tuning/calibrated_robot.hpp"

namespace slam_ros {

RunRecorder::RunRecorder(OutputsConfig config, std::string map_frame, slam::Settings settings,
                         std::string robot_file, Diagnostics& diagnostics)
    : config_(std::move(config)),
      map_frame_(std::move(map_frame)),
      settings_(std::move(settings)),
      robot_file_(std::move(robot_file)),
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

void RunRecorder::write(const slam::StepReport& report, RunMetrics::Clock::duration time) {
  if (!metrics_ || report.restarted) {
    metrics_.emplace();
    first_stamp_ = report.stamp;
  }
  if (report.hasTrigger()) metrics_->addUpdate(time);
  metrics_->addEvents(report);
  if (report.hasTrigger()) metrics_->addTrust(report.stamp, report.trust);
  last_stamp_ = report.stamp;
  if (writer_) attempt([&] { writer_->write(report); });
}

void RunRecorder::restart() {
  metrics_.reset();
  if (writer_) attempt([&] { writer_->restart(); });
}

void RunRecorder::finish(const slam::Capabilities& backend, std::uint64_t dropped_messages) {
  if (writer_)
    attempt([&] {
      if (metrics_) {
        metrics_->setGrid(backend);
        slam::writeFileAtomically(writer_->unfinished() + "/metrics.json",
                                  metrics_->toJson(last_stamp_ - first_stamp_, dropped_messages));
      }
      const auto fault = slam::tuning::saveCalibration(
          backend, settings_, [this] { return robot_file_; }, writer_->unfinished());
      if (!fault.empty()) diagnostics_.warn(fault);
      writer_->finish(backend, map_frame_, settings_.inForce());
    });
  if (config_.save_on_exit.empty()) return;
  const auto* keeper = backend.find<slam::MapKeeper>();
  if (keeper == nullptr) return;
  attempt([&] {
    slam::saveMap(config_.save_on_exit + "/landmarks.yaml",
                  {map_frame_, last_stamp_, keeper->state()});
  });
}

}  // namespace slam_ros
