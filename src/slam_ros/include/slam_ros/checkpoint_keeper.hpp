// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/product/autosave.hpp"
#include "slam_core/product/checkpoint.hpp"
#include "slam_core/product/checkpoint_folder.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/background.hpp"
#include "slam_ros/checkpoint_config.hpp"
#include "slam_ros/stage_states.hpp"

namespace slam_ros {

/// Saves a product, or its part that has the back-end, with the stages beside it during a run, and
/// restores them. The state is copied between two steps, in the thread that takes them; another
/// thread writes it to the disk. Components in other processes start over.
class CheckpointKeeper {
 public:
  /// Locks the folder, if there is one. @param handle has the parameters; `restarted` is set, so
  /// that a nodelet that this launch starts again goes on @param product outlives this
  /// @param stages outlive this; resume() restores their state
  /// @throw std::runtime_error naming the folder and the cause
  CheckpointKeeper(ros::NodeHandle handle, slam::RunIdentity run, slam::MetaCoordinator& product,
                   const StageStates& stages);
  ~CheckpointKeeper();

  /// If requested, restores the folder's last checkpoint that can be used.
  /// @param configure_anew configures again what was only partly restored
  /// @return whether the product goes on; otherwise it starts over
  bool resume(const std::function<void()>& configure_anew);
  /// The messages of resume(), for the log.
  struct News {
    std::vector<std::string> warnings;
    std::string text;
  };
  const News& news() const { return news_; }

  /// Moves the last checkpoint aside, since from here on the product has another map.
  void beginAnew();
  /// To be called when all steps that were due have been taken.
  /// @return a sentence if checkpoints cannot be written any more, or can be written again;
  /// otherwise empty
  std::string note(slam::Stamp last_step);
  /// @return the longest time for which steps have waited while the state was copied [ms]
  double longestPause() const { return longest_pause_; }
  /// Saves once more, at the end. @return as note()
  std::string finish();

 private:
  bool resumeProduct(const std::function<void()>& configure_anew);
  void restore(const std::string& bytes);
  void describe(const slam::CheckpointFolder::Resumption& resumption);
  void save();
  void write(const std::string& state);
  void fail(const std::string& cause);
  void tell(const std::string& sentence);
  std::string takeNews();

  CheckpointConfig config_;
  slam::RunIdentity run_;
  slam::MetaCoordinator& product_;
  const StageStates& stages_;
  StageStates::Saved saved_stages_;  ///< that the product goes on from
  slam::Autosave autosave_;
  std::unique_ptr<slam::CheckpointFolder> folder_;  ///< none if nothing is to be saved
  News news_;
  std::optional<slam::Stamp> last_step_, saved_;
  double longest_pause_ = 0.0;
  bool has_failed_ = false;  ///< to write the last one; used by the writing thread
  std::mutex mutex_;
  std::string news_of_writing_;  ///< guarded by the mutex
  Background writing_;
};

}  // namespace slam_ros
