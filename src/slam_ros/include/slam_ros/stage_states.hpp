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

/// The stages of a product that run in nodelets of their own beside that of the back-end, for the
/// back-end's.
class StageStates {
 public:
  using Saved = std::map<std::string, std::string>;  ///< states by the stage's name

  StageStates() = default;
  /// None where the back-end's part of the product has the stages itself.
  StageStates(const ros::NodeHandle& product, const slam::ProductComponents& part);

  /// The name of a stage that cannot be copied, since it runs in another process; else empty.
  std::string missing() const;
  /// To be called once the back-end's own state has been copied. The stages are copied against the
  /// flow of the data: whatever one state refers to, the state of who has made that knows.
  Saved copy() const;
  /// @throw std::runtime_error where they are no states of these stages
  void require(const Saved& saved) const;
  /// Each stage goes on from what was saved; those of which nothing was begin anew.
  void goOnFrom(const Saved& saved) const;

 private:
  ros::NodeHandle product_;
  std::vector<std::pair<std::string, std::shared_ptr<StageState>>> stages_;  ///< makers first
};

}  // namespace slam_ros
