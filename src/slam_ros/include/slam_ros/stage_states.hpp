// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/product/product_components.hpp"
#include "slam_ros/stage_state.hpp"

namespace slam_ros {

/// The stages of a product that run in nodelets of their own, as the back-end's nodelet sees them.
class StageStates {
 public:
  using Saved = std::map<std::string, std::string>;  ///< states by the stage's name

  StageStates() = default;
  /// None if the back-end's part of the product contains the stages itself.
  StageStates(const ros::NodeHandle& product, const slam::ProductComponents& part);

  /// The name of a stage that runs in another process, so that it cannot be copied; else empty.
  std::string missing() const;
  /// To be called after the back-end's own state was copied. The stages are copied against the flow
  /// of the data, so that each copy contains all that the copies before refer to.
  Saved copy() const;
  /// @throw std::runtime_error if these are not states of these stages
  void require(const Saved& saved) const;
  /// Each stage restores its saved state; a stage without one is reset.
  void goOnFrom(const Saved& saved) const;

 private:
  ros::NodeHandle product_;
  std::vector<std::pair<std::string, std::shared_ptr<StageState>>> stages_;  ///< makers first
};

}  // namespace slam_ros
