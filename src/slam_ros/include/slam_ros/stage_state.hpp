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

/// What a stage knows whose nodelet runs beside the back-end's in one process. The back-end's
/// nodelet copies it into its own checkpoint and says what the stage goes on from, since the one
/// refers to what the other has numbered. Nodelets call it from threads of their own.
class StageState {
 public:
  /// The same for the nodelets of the stage and of the back-end. @param product its namespace
  static std::shared_ptr<StageState> of(const std::string& product, const std::string& stage);

  /// The stage's nodelet begins with this part of the product, which is configured.
  /// @param has_checkpoints it takes nothing in before the back-end has said what it goes on from
  void open(slam::MetaCoordinator& part, bool has_checkpoints);
  /// Runs what takes data in, while nobody copies the state; not while the stage waits.
  void take(const std::function<void()>& action);
  bool isWaiting();
  /// The stage's nodelet ends: what it knows stays, where there are checkpoints.
  void close();

  /// Before it takes in more, the stage goes on from here; from nothing where this is empty.
  void goOnFrom(const std::string& state);
  /// Whether there is anything to copy: a stage that runs in another process has nothing here.
  bool isHere();
  std::string copy();

 private:
  std::string now() const;

  std::mutex mutex_;
  slam::MetaCoordinator* part_ = nullptr;
  bool has_checkpoints_ = false, is_waiting_ = false;
  std::string fresh_;                ///< the part's state as it was configured
  std::string last_;                 ///< when its nodelet ended
  std::optional<std::string> next_;  ///< what it goes on from
};

}  // namespace slam_ros
