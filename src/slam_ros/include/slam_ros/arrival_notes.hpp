// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <slam_msgs/Progress.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/product/data_flow.hpp"
#include "slam_core/product/intake.hpp"

namespace slam_ros {

/// Notes what has come to a back-end's node in addition to what the back-end's intake notes itself:
/// data that reach it through a gate and data of modules, which nobody else acknowledges, and the
/// topic on which motion comes.
class ArrivalNotes {
 public:
  ArrivalNotes() = default;
  ArrivalNotes(const slam::DataFlow& flow, const slam::Ports& of_backend);

  /// To be called with every value that comes in.
  void take(const std::string& port, slam::Kind kind, const void* value);
  /// To be called when a message has been taken. @param motion the newest motion
  void taken(const std::string& topic, const std::optional<slam::Stamp>& motion);
  /// The topic whose message last brought newer motion; empty before there is any motion.
  const std::string& motionTopic() const { return motion_topic_; }
  /// Acknowledges all that has come, whether or not it could be used.
  void acknowledge(const slam::Intake::Arrivals& arrivals, slam_msgs::Progress& message) const;
  /// To be called after a restart. Data from before are of another time; they are acknowledged
  /// already, since each message is acknowledged when it is taken.
  void forget();

 private:
  std::vector<slam::InputPort> inputs_;        ///< that are noted
  std::map<std::string, slam::Stamp> newest_;  ///< of their data, by input
  std::optional<slam::Stamp> last_motion_;
  std::string motion_topic_;
};

}  // namespace slam_ros
