// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>

#include <functional>
#include <utility>
#include <vector>

#include "slam_core/common/config_fields.hpp"

namespace slam_ros {

/// Makes the live fields of a configuration changeable while a nodelet runs, by the protocol of
/// dynamic_reconfigure: rqt_reconfigure shows them, `dynparam set` changes them. Names, sentences
/// and ranges are those of the configuration's description.
class LiveParameters {
 public:
  /// @param handle the nodelet's private one
  /// @param config outlives this; its live fields are numbers or switches
  /// @param changed called after a change, by the thread of the handle's callbacks
  template <class Config>
  LiveParameters(const ros::NodeHandle& handle, Config* config, std::function<void()> changed)
      : changed_(std::move(changed)) {
    config->describe(fields_);
    start(handle);
  }

 private:
  void start(ros::NodeHandle handle);
  bool set(dynamic_reconfigure::Reconfigure::Request& request,
           dynamic_reconfigure::Reconfigure::Response& response);
  void publishDescription(ros::NodeHandle& handle);
  dynamic_reconfigure::Config inForce() const;

  slam::Fields fields_;
  std::vector<const slam::Field*> live_;
  std::function<void()> changed_;
  ros::Publisher descriptions_, updates_;
  ros::ServiceServer service_;
};

}  // namespace slam_ros
