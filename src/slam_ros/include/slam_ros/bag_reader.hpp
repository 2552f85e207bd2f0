// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_ros/bag_message.hpp"
#include "slam_ros/topic_matching.hpp"

namespace slam_ros {

/// A bag that is read, in the order of its receive times; only the topics asked for are touched. A
/// damaged bag costs a sentence, whatever the library makes of it (bag_process.hpp).
/// Everything throws std::runtime_error, one sentence that names the bag and what is wrong with it.
class BagReader {
 public:
  /// @throw when it is missing, a folder, no bag, or was not closed properly
  explicit BagReader(const std::string& path);

  const std::string& path() const { return path_; }
  /// Sorted by name.
  const std::vector<BagTopic>& topics() const { return topics_; }
  const BagTopic* find(const std::string& topic) const { return findTopic(topics_, topic); }
  std::size_t messages(const BagHandlers& handlers) const;

  slam::Stamp begin() const { return begin_; }
  slam::Stamp end() const { return end_; }

  /// Calls the handlers, a topic each, message by message. `progress` is told how many messages are
  /// done; the reading ends when it returns false.
  void read(const BagHandlers& handlers,
            const std::function<bool(std::size_t done)>& progress = {}) const;

  /// The name of the robot file in the topic `robot`; empty where the bag does not tell.
  std::string robot() const;

 private:
  std::string path_;
  std::vector<BagTopic> topics_;
  slam::Stamp begin_, end_;
};

}  // namespace slam_ros
