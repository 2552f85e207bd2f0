// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fstream>
#include <optional>
#include <string>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {

/// One line of a TUM trajectory: "stamp x y 0 0 0 qz qw", nine decimals.
std::string tumLine(Stamp stamp, const Pose2& pose);

/// Writes a run's folder while it goes on: trajectory.tum, trajectory_final.tum, odometry.tum,
/// updates.csv; landmarks.yaml, of a grid map.yaml and map.pgm, and config.yaml at the end. Every
/// driver of an Estimator uses this one, so that offline and online runs can be compared byte for
/// byte.
class RunWriter {
 public:
  /// Makes the folder; files of an earlier run in it are replaced, its evaluation is removed.
  /// @throw std::runtime_error naming the folder and the cause
  explicit RunWriter(const std::string& folder);

  /// Takes the steps in order; writes those that came from observations or scans, steps of the same
  /// stamp as one: the pose of the last of them, their statistics added up. It is written when the
  /// next one comes. A restart begins anew.
  /// @throw std::runtime_error when the disk is full
  void write(const StepReport& report);

  /// The final trajectory has the poses of the back-end's path() where it has one.
  /// @throw std::runtime_error naming the file that could not be written
  void finish(const Backend& backend, const std::string& map_frame, const std::string& config);

  const std::string& folder() const { return folder_; }
  /// Of the trajectory, that of the last step included.
  std::size_t lines() const { return lines_ + (pending_ ? 1 : 0); }

 private:
  void open(const std::string& name, std::ofstream& file) const;
  void begin();
  void writePending();

  std::string folder_;
  std::ofstream trajectory_, odometry_, updates_;
  std::optional<StepReport> pending_;
  Stamp last_stamp_;
  std::size_t lines_ = 0;
};

}  // namespace slam
