// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/time.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/product/run_folder.hpp"
#include "slam_core/product/step_report.hpp"

namespace slam {

/// One line of a TUM trajectory: "stamp x y 0 0 0 qz qw", nine decimals.
std::string tumLine(Stamp stamp, const Pose2& pose);
/// The same for a position [m] alone: its quaternion is "0 0 0 0".
std::string tumLineWithoutHeading(Stamp stamp, const Eigen::Vector2d& position);

/// Writes a run's folder while it goes on: trajectory.tum, trajectory_final.tum, odometry.tum,
/// updates.csv, events.csv, associations.csv where observations are associated by place, views.csv
/// where features are followed through images; landmarks.yaml, of a grid map.yaml and map.pgm, of a
/// graph graph.csv, of recognised places places.csv, of sessions that were not merged
/// unmerged_1.session, ..., and config.yaml at the end. Every driver of an Estimator uses this one,
/// so that offline and online runs can be compared byte for byte. Until finish() they stand in
/// unfinished(), beside what an earlier run has left.
class RunWriter {
 public:
  using Start = RunFolder::Start;

  /// Makes and locks the folder. A run that is resumed goes on with restoreState().
  /// @throw std::runtime_error naming the folder and the cause
  explicit RunWriter(const std::string& folder, Start start = Start::kAnew);
  /// Without finish() the folder is as before, but for an unfinished run that has written poses or
  /// was resumed.
  ~RunWriter();
  RunWriter(const RunWriter&) = delete;
  RunWriter& operator=(const RunWriter&) = delete;

  /// Takes the steps in order; writes those that came from observations or scans, steps of the same
  /// stamp as one: the pose of the last of them, their statistics added up. It is written when the
  /// next one comes. A report of a restart does as restart().
  /// @throw std::runtime_error when the disk is full
  void write(const StepReport& report);

  /// The files start over; what stands in them is kept in trajectory.before_restart_1.tum, ..._2
  /// and so on, and likewise named ones of odometry, updates and events, of the last hundred
  /// restarts.
  /// @throw std::runtime_error naming the file that could not be written
  void restart();

  /// What the back-end can do decides on the files: its map where it keeps one; the final
  /// trajectory has the poses of its path where it revises it. All that stands in unfinished()
  /// takes the place of the files of an earlier run, whose evaluation is removed. To be called
  /// once.
  /// @throw std::runtime_error naming the file that could not be written
  void finish(const Capabilities& backend, const std::string& map_frame, const std::string& config);

  /// Saves what a writer needs to go on from here; all that has been written is on the disk then.
  /// @throw std::runtime_error naming the file and the cause
  void saveState(ArchiveWriter& archive);
  /// Goes on from there: what was written later is cut off.
  /// @throw std::runtime_error naming a file that was changed meanwhile
  void restoreState(ArchiveReader& archive);

  const std::string& folder() const { return folder_.path(); }
  /// Where others put what belongs to the run, before finish().
  const std::string& unfinished() const { return folder_.unfinished(); }
  /// How many lines the trajectory has, that of the last step included.
  std::size_t lines() const { return lines_ + (pending_ ? 1 : 0); }

 private:
  void open(const std::string& name, std::ofstream& file) const;
  static constexpr std::size_t kMostKept = 100;

  void begin();
  std::array<std::pair<std::string, std::ofstream*>, 6> files();
  void undoRestart();
  void keep(const std::string& name, std::ofstream& file) const;
  void writePending();
  void writeAssociations(const StepReport& report);
  void writeView(const StepReport& report);

  RunFolder folder_;
  bool is_resumed_;
  std::ofstream trajectory_, odometry_, updates_, events_;
  std::ofstream associations_, views_;  ///< opened when there is something to write
  std::optional<StepReport> pending_;
  Stamp last_stamp_;
  std::size_t lines_ = 0;
  std::size_t restarts_ = 0;  ///< that there was something to keep of
};

}  // namespace slam
