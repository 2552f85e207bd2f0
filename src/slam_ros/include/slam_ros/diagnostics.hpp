// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"
#include "slam_ros/door.hpp"

namespace slam_ros {

/// Reports the state of a nodelet: once a second on /diagnostics, with level, message and all
/// counters. Each kind of warning is also reported on the console, at most once in five seconds of
/// the wall clock. An input that has not come in the first five seconds is named there as well,
/// once.
class Diagnostics {
 public:
  using Values = std::vector<std::pair<std::string, std::string>>;
  struct Sources {
    std::function<slam::Counters()> counters;
    /// "waiting for ...", or empty if all inputs have come
    std::function<std::string()> waiting;
    /// the same, for inputs that have never come
    std::function<std::string()> missing;
    /// further lines of name and value; may be empty
    std::function<Values()> values = {};
  };

  /// @param name of the nodelet
  Diagnostics(ros::NodeHandle handle, ros::NodeHandle private_handle, const std::string& name,
              Sources sources);
  /// Reports what has been counted since the last report.
  ~Diagnostics();

  /// From here on the timer does not call the sources any more. To be called before the objects
  /// that they use are destroyed. Waits for a call that is under way.
  void stop() { timer_.stop(); }

  /// Adds another status beside the nodelet's own; `fill` is called once a second.
  void add(const std::string& name, const diagnostic_updater::TaskFunction& fill) {
    updater_.add(name, fill);
  }
  /// Reports the status that a component returned for the last message on `topic`.
  void report(const std::string& topic, const slam::Status& status);
  void warn(const std::string& sentence);
  /// Reports on the console only, as long as it holds, what `waiting` says.
  void tell(ros::console::Level level, const std::string& sentence);
  /// Reports a permanent fault, such as a full disk; it stays until the node ends.
  void fail(const std::string& sentence);
  /// Runs a callback of a nodelet (door.hpp) and reports an exception as an error.
  void attempt(const std::string& topic, const Action& action);
  /// The same for a callback that may leave something half done: if it throws, no more input is
  /// taken until recover().
  void guard(const std::string& topic, const Action& action);
  /// Whether callbacks are accepted.
  bool isGuardOpen() const { return door_.fault().empty(); }
  /// To be called when everything starts over.
  void recover() { door_.open(); }

 private:
  void tick();
  void warnOfCounters();
  void warnOfMissing();
  void fill(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::string name_;
  Sources sources_;
  diagnostic_updater::Updater updater_;
  std::map<std::string, ros::WallTime> told_;  ///< when each kind of warning was last reported
  slam::Counters counted_;                     ///< what has been reported
  std::string last_warning_, failure_;
  Door door_;
  std::string missing_;  ///< inputs that had never come at the last report
  ros::WallTime missing_since_;
  bool is_missing_told_ = false;
  ros::WallTime last_warning_time_;
  bool is_last_an_error_ = false;
  ros::WallTimer timer_;
};

}  // namespace slam_ros
