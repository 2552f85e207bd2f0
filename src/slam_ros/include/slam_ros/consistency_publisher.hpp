// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <slam_msgs/Consistency.h>

#include <deque>

#include "slam_core/product/estimator.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/truth_comparison.hpp"

namespace slam_ros {

/// Publishes the results of the consistency monitor: on `consistency` after every update, and as a
/// diagnostic that warns while the pose may be lost, innovations are biased or a sigma looks too
/// small. If the truth comes on `ground_truth/pose`, it publishes the NEES as well; then a message
/// waits until the truth of its stamp has come.
class ConsistencyPublisher {
 public:
  /// Both must outlive the updates of the diagnostics.
  ConsistencyPublisher(ros::NodeHandle handle, Diagnostics& diagnostics,
                       const slam::ConsistencyMonitor& monitor);

  /// Subscribes to the truth, once the nodelet is loaded (AfterLoad).
  void subscribe(ros::NodeHandle handle);

  void publish(const slam::StepReport& report);
  /// To be called when map and pose start over.
  void restart();

 private:
  struct Pending {
    slam_msgs::Consistency message;
    slam::Stamp stamp;
    slam::PoseEstimate pose;
  };

  void onTruth(const geometry_msgs::PoseStamped& message);
  void flush();
  slam_msgs::Consistency messageOf(const slam::StepReport& report) const;
  void fill(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  const slam::ConsistencyMonitor& monitor_;
  TruthComparison truth_;
  std::deque<Pending> pending_;
  double nees_ = -1.0;                         ///< the newest one
  slam::Trust trust_ = slam::Trust::kUnknown;  ///< after the last step
  std::string doubt_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace slam_ros
