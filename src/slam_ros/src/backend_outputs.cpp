// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/backend_outputs.hpp"

namespace slam_ros {
namespace {

constexpr double kFlushInterval = 0.5;  // [s] of the wall: stamps may stand still

}  // namespace

BackendOutputs::BackendOutputs(ros::NodeHandle handle, const slam::Estimator& estimator,
                               const std::string& map_frame, const OutputsConfig& config,
                               const slam::JumpLimit::Limits& limits)
    : pose_(handle, map_frame, config.landmark_rate),
      map_odom_(handle, map_frame, config, limits),
      events_(handle, map_frame) {
  const auto& backend = estimator.capabilities();
  if (const auto* mapper = backend.find<slam::LandmarkMapper>())
    landmarks_.emplace(handle, *mapper, map_frame, config.landmark_rate);
  if (const auto* sampler = backend.find<slam::PoseSampler>())
    particles_.emplace(handle, *sampler, map_frame, config.landmark_rate);
  if (const auto* mapper = backend.find<slam::GridMapper>())
    grid_.emplace(handle, *mapper, map_frame, config.map_period);
  if (const auto* reporter = backend.find<slam::GraphReporter>())
    graph_.emplace(handle, *reporter, map_frame, config.map_period);
  if (const auto* mapper = backend.find<slam::FeatureMapper>())
    features_.emplace(handle, *mapper, map_frame, config.landmark_rate);
  drawer_ = backend.find<slam::ViewDrawer>();
  if (drawer_ != nullptr) drawing_.emplace(handle, "");
  const auto flush = [this](const ros::WallTimerEvent&) {
    pose_.flush();
    if (landmarks_) landmarks_->flush();
    if (grid_) grid_->flush();
    if (graph_) graph_->flush();
  };
  flush_timer_ = handle.createWallTimer(ros::WallDuration(kFlushInterval), flush);
}

void BackendOutputs::configure(const OutputsConfig& config) {
  pose_.setRate(config.landmark_rate);
  if (landmarks_) landmarks_->setRate(config.landmark_rate);
  if (particles_) particles_->setRate(config.landmark_rate);
  if (grid_) grid_->setRate(1.0 / config.map_period);
  if (graph_) graph_->setRate(1.0 / config.map_period);
  if (features_) features_->setRate(config.landmark_rate);
  map_odom_.configure(config);
}

void BackendOutputs::publish(const slam::StepReport& report) {
  pose_.publish(report);
  if (landmarks_) landmarks_->update(report.stamp);
  map_odom_.update(report);
  if (particles_) particles_->update(report.stamp);
  if (grid_) grid_->update(report.stamp);
  if (graph_) graph_->update(report.stamp);
  if (features_) features_->update(report.stamp);
  if (drawing_) drawing_->publish(*drawer_, report.stamp, report.base_frame);
  events_.publish(report);
}

void BackendOutputs::refresh() {
  if (landmarks_) landmarks_->refresh();
  if (graph_) graph_->refresh();
}

void BackendOutputs::restart() {
  pose_.reset();
  refresh();
  map_odom_.reset();
}

}  // namespace slam_ros
