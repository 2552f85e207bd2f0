// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_ros/detections_publisher.hpp"
#include "slam_ros/event_publisher.hpp"
#include "slam_ros/feature_publisher.hpp"
#include "slam_ros/graph_publisher.hpp"
#include "slam_ros/grid_publisher.hpp"
#include "slam_ros/landmark_publisher.hpp"
#include "slam_ros/map_odom_broadcaster.hpp"
#include "slam_ros/particle_publisher.hpp"
#include "slam_ros/pose_publisher.hpp"

namespace slam_ros {

/// Publishes the results of a step, depending on the back-end's capabilities. Results that a rate
/// limit held back are published when no further step comes.
class BackendOutputs {
 public:
  BackendOutputs(ros::NodeHandle handle, const slam::Estimator& estimator,
                 const std::string& map_frame, const OutputsConfig& config,
                 const slam::JumpLimit::Limits& limits);

  /// Takes over rates, periods and the transform's tolerance.
  void configure(const OutputsConfig& config);
  void publish(const slam::StepReport& report);
  /// To be called when the map was replaced.
  void refresh();
  /// Starts path and transform over.
  void restart();

 private:
  PosePublisher pose_;
  std::optional<LandmarkPublisher> landmarks_;
  MapOdomBroadcaster map_odom_;
  std::optional<ParticlePublisher> particles_;
  std::optional<GridPublisher> grid_;
  std::optional<GraphPublisher> graph_;
  std::optional<FeaturePublisher> features_;
  const slam::ViewDrawer* drawer_ = nullptr;  ///< null: the back-end uses no camera
  std::optional<DetectionsPublisher> drawing_;
  EventPublisher events_;
  ros::WallTimer flush_timer_;
};

}  // namespace slam_ros
