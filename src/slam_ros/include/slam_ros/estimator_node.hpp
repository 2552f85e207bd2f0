// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <slam_msgs/LandmarkObservationArray.h>
#include <slam_msgs/Motion.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "slam_ros/after_load.hpp"
#include "slam_ros/backend_outputs.hpp"
#include "slam_ros/backend_services.hpp"
#include "slam_ros/clock_watch.hpp"
#include "slam_ros/consistency_publisher.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/laser_subscriber.hpp"
#include "slam_ros/run_recorder.hpp"
#include "slam_ros/silence_watch.hpp"
#include "slam_ros/step_source.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

/// The ROS side of an estimator, the same for every back-end and both compositions: subscribes
/// motion, observations, initialpose and, where they are used, scans, and turns each step into
/// pose, path, landmarks, transform, progress, diagnostics and the files of the run. All callbacks
/// come from one thread, one at a time. Destroying it completes the files.
class EstimatorNode {
 public:
  struct Handles {
    ros::NodeHandle product, own;  ///< the product's namespace and the nodelet's private one
    std::string name;              ///< of the nodelet
  };

  /// Configures `source`, which must outlive this.
  /// @throw slam::ConfigError, std::runtime_error
  EstimatorNode(const Handles& handles, const OutputsConfig& outputs, StepSource& source);
  ~EstimatorNode();
  EstimatorNode(const EstimatorNode&) = delete;
  EstimatorNode& operator=(const EstimatorNode&) = delete;

  const TopicsConfig& topics() const { return topics_; }
  Diagnostics& diagnostics() { return *diagnostics_; }

  /// To be called before an input is set: begins anew when the clock has jumped back.
  void checkClock();
  /// To be called after an input was set: takes and publishes all steps that are due.
  void takeSteps(const std::string& topic);
  /// Called with every step.
  std::function<void(const slam::StepReport&)> on_step;
  /// Called when all steps that were due have been taken.
  std::function<void()> on_idle;
  /// What the front-end in this process waits for ("waiting for ..."), where there is one.
  std::function<std::string()> front_end_waiting;

 private:
  void onMotion(const slam_msgs::Motion& message);
  void onObservations(const slam_msgs::LandmarkObservationArray& message);
  void onInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message);

  void subscribe(ros::NodeHandle handle);
  void connectLaser(ros::NodeHandle handle, slam::Settings& settings);
  BackendActions actions();
  void tellOfSilence();
  std::string waiting() const;
  std::string starving() const;
  Diagnostics::Values figures() const;
  void publishStep(const slam::StepReport& report, RunMetrics::Clock::duration time);
  void publishProgress();
  void beginAnew();
  void reset();
  void tellOfReset();

  StepSource& source_;
  TopicsConfig topics_;
  std::string map_frame_;
  ClockWatch clock_;
  SilenceWatch silence_;
  std::optional<Diagnostics> diagnostics_;
  std::optional<RunRecorder> recorder_;
  std::optional<BackendOutputs> outputs_;
  std::optional<ConsistencyPublisher> consistency_;
  std::optional<BackendServices> services_;
  std::string motion_frames_;
  ros::Publisher progress_;
  std::atomic<bool> tells_progress_{false};  ///< from when on progress_ is there
  std::vector<ros::Subscriber> subscribers_;
  std::optional<LaserSubscriber> laser_;
  slam::Stamp last_scan_;     ///< that has come, whether or not it could be used
  std::uint32_t resets_ = 0;  ///< that were asked for, maps that were loaded included
  ros::WallTimer silence_timer_;
  std::optional<slam::Stamp> last_motion_;
  std::string motion_topic_;  ///< that the last motion came of
  bool is_starving_ = false;  ///< and that has been told
  std::optional<AfterLoad> start_;
};

}  // namespace slam_ros
