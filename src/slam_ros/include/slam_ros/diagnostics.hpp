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

/// Tells how a nodelet is doing: once a second on /diagnostics, with level, message and all
/// counters; and each kind of warning on the console, at most once in five seconds of the wall. An
/// input that has not come for the first five seconds is named there as well, once.
class Diagnostics {
 public:
  using Values = std::vector<std::pair<std::string, std::string>>;
  struct Sources {
    std::function<slam::Counters()> counters;
    /// "waiting for ...", or empty when all inputs have come
    std::function<std::string()> waiting;
    /// as that, of inputs of which nothing has ever come
    std::function<std::string()> missing;
    /// further lines of name and value; may be empty
    std::function<Values()> values = {};
  };

  /// @param name of the nodelet
  Diagnostics(ros::NodeHandle handle, ros::NodeHandle private_handle, const std::string& name,
              Sources sources);
  /// Tells what has been counted since the last second.
  ~Diagnostics();

  /// From here on the sources are not asked by the timer; to be called before what they ask goes
  /// away. Waits for a call that is under way.
  void stop() { timer_.stop(); }

  /// A further status beside the nodelet's own; `fill` is called once a second.
  void add(const std::string& name, const diagnostic_updater::TaskFunction& fill) {
    updater_.add(name, fill);
  }
  /// The answer of a component to the message that came last on `topic`.
  void report(const std::string& topic, const slam::Status& status);
  void warn(const std::string& sentence);
  /// On the console only: what `waiting` tells as long as it holds.
  void tell(ros::console::Level level, const std::string& sentence);
  /// What does not pass by itself, such as a full disk; stays until the node ends.
  void fail(const std::string& sentence);
  /// Runs a callback of a nodelet (door.hpp) and reports an exception as an error.
  void attempt(const std::string& topic, const Action& action);
  /// The same where it may leave something half done: nothing more is taken in until recover().
  void guard(const std::string& topic, const Action& action);
  /// Whether it lets callbacks in.
  bool isGuardOpen() const { return door_.fault().empty(); }
  /// Everything starts over.
  void recover() { door_.open(); }

 private:
  void tick();
  void warnOfCounters();
  void warnOfMissing();
  void fill(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::string name_;
  Sources sources_;
  diagnostic_updater::Updater updater_;
  std::map<std::string, ros::WallTime> told_;  ///< kind of warning, when it was reported last
  slam::Counters counted_;                     ///< what has been reported
  std::string last_warning_, failure_;
  Door door_;
  std::string missing_;  ///< what has never come, as of the last second
  ros::WallTime missing_since_;
  bool is_missing_told_ = false;
  ros::WallTime last_warning_time_;
  bool is_last_an_error_ = false;
  ros::WallTimer timer_;
};

}  // namespace slam_ros
