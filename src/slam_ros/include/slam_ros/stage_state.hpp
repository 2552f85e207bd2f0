// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "slam_core/product/meta_coordinator.hpp"

namespace slam_ros {

/// The state of a stage whose nodelet runs in the same process as that of the back-end. The
/// back-end's nodelet copies it into its own checkpoint and tells the stage which state to restore,
/// since the back-end's state refers to numbers that the stage has given. Safe to be called from
/// the threads of both nodelets.
class StageState {
 public:
  /// The one that the nodelets of the stage and of the back-end share. @param product its namespace
  static std::shared_ptr<StageState> of(const std::string& product, const std::string& stage);

  /// The stage's nodelet starts, with this configured part of the product.
  /// @param has_checkpoints the stage takes in nothing before goOnFrom() was called
  void open(slam::MetaCoordinator& part, bool has_checkpoints);
  /// Runs an action that takes in data, while nobody copies the state; nothing while the stage
  /// waits.
  void take(const std::function<void()>& action);
  bool isWaiting();
  /// The stage's nodelet ends; with checkpoints its state is kept.
  void close();

  /// The stage restores this state before it takes in more; it is reset if the state is empty.
  void goOnFrom(const std::string& state);
  /// Whether there is anything to copy: a stage that runs in another process has nothing here.
  bool isHere();
  std::string copy();

 private:
  std::string now() const;

  std::mutex mutex_;
  slam::MetaCoordinator* part_ = nullptr;
  bool has_checkpoints_ = false, is_waiting_ = false;
  std::string fresh_;                ///< state after the configuration
  std::string last_;                 ///< state when its nodelet ended
  std::optional<std::string> next_;  ///< state to restore
};

}  // namespace slam_ros
