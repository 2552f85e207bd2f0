// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/product/data_flow.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/arrival_notes.hpp"
#include "slam_ros/backend_outputs.hpp"
#include "slam_ros/backend_services.hpp"
#include "slam_ros/checkpoint_keeper.hpp"
#include "slam_ros/clock_watch.hpp"
#include "slam_ros/consistency_publisher.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/live_parameters.hpp"
#include "slam_ros/localisation_services.hpp"
#include "slam_ros/part_inputs.hpp"
#include "slam_ros/run_recorder.hpp"
#include "slam_ros/silence_watch.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

/// The ROS side of an estimator, the same for every back-end and both compositions. It subscribes
/// to initialpose and to all inputs of its part of the product, and publishes pose, path,
/// landmarks, transform, progress and diagnostics of each step, and writes the files of the run.
/// All callbacks come from one thread, one at a time. Destroying it completes the files.
class EstimatorNode {
 public:
  struct Handles {
    ros::NodeHandle product, own;  ///< the product's namespace and the nodelet's private one
    std::string name;              ///< of the nodelet
  };

  /// Configures `coordinator`, which must outlive this, for a part of the product.
  /// @throw slam::ConfigError, std::runtime_error
  EstimatorNode(const Handles& handles, const OutputsConfig& outputs,
                slam::MetaCoordinator& coordinator, const slam::ProductPart& part,
                const InputOptions& inputs = {});
  ~EstimatorNode();
  EstimatorNode(const EstimatorNode&) = delete;
  EstimatorNode& operator=(const EstimatorNode&) = delete;

  const TopicsConfig& topics() const { return topics_; }
  Diagnostics& diagnostics() { return *diagnostics_; }

  /// The wrapper for the callbacks of a front-end in this process, which this object's own
  /// callbacks use as well.
  Pass pass();

  /// The topics to which it subscribes.
  const PartInputs& inputs() const { return *inputs_; }
  /// Called with every step.
  std::function<void(const slam::StepReport&)> on_step;
  /// Called when all steps that were due have been taken.
  std::function<void()> on_idle;

 private:
  /// Starts over when the clock has jumped back.
  void checkClock();
  /// Takes and publishes all steps that are due.
  void takeSteps(const std::string& topic);
  void take(const std::string& port, slam::Kind kind, const void* value, const std::string& topic);
  void noteFrames(const slam::Motion& motion, const std::string& topic);
  void onInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message);

  void subscribe(ros::NodeHandle handle);
  void connect(const ros::NodeHandle& handle, slam::Settings& settings,
               const InputOptions& options);
  bool resume(const ros::NodeHandle& product, slam::Settings& settings,
              const slam::ProductPart& part);
  void saveLast();
  slam::Status startWithSession(const OutputsConfig& outputs);
  BackendActions actions();
  LocalisationActions localisationActions();
  slam::Status tellingOfMap(slam::Status status);
  void tellOfSilence();
  std::string waiting() const;
  std::string missing() const;
  std::vector<slam::InputPort> needlessInputs() const;
  std::string starving() const;
  Diagnostics::Values figures() const;
  void publishStep(const slam::StepReport& report, RunMetrics::Clock::duration time);
  void publishProgress();
  void beginAnew();
  void reset();
  void tellOfReset();

  slam::Estimator& estimator() { return coordinator_.estimator(); }
  const slam::Estimator& estimator() const { return coordinator_.estimator(); }

  slam::MetaCoordinator& coordinator_;
  TopicsConfig topics_;
  std::string map_frame_;
  ClockWatch clock_;
  SilenceWatch silence_;
  std::optional<Diagnostics> diagnostics_;
  std::optional<RunRecorder> recorder_;
  StageStates stages_;
  std::optional<CheckpointKeeper> checkpoints_;
  std::optional<BackendOutputs> outputs_;
  OutputsConfig live_config_;
  std::optional<LiveParameters> live_;  ///< of live_config_
  std::optional<ConsistencyPublisher> consistency_;
  std::optional<BackendServices> services_;
  std::optional<LocalisationServices> localisation_;
  std::string motion_frames_;
  ros::Publisher progress_;
  std::atomic<bool> tells_progress_{false};  ///< whether progress_ exists already
  std::vector<ros::Subscriber> subscribers_;
  std::optional<PartInputs> inputs_;
  std::optional<slam::DataFlow> flow_;
  ArrivalNotes notes_;
  std::optional<slam::Stamp> last_step_;
  std::uint32_t resets_ = 0;  ///< that were requested; loaded maps count as well
  ros::WallTimer silence_timer_;
  bool is_starving_ = false;  ///< and that has been reported
  std::optional<AfterLoad> start_;
};

}  // namespace slam_ros
