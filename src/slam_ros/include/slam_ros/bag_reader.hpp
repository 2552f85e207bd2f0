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

/// Reads a bag in the order of its receive times; only the requested topics are read. A damaged bag
/// leads to an exception, whatever the bag library does (bag_process.hpp). All functions throw
/// std::runtime_error, with one sentence that names the bag and what is wrong with it.
class BagReader {
 public:
  /// @throw if it is missing, is a folder or not a bag, or was not closed properly
  explicit BagReader(const std::string& path);

  const std::string& path() const { return path_; }
  /// Sorted by name.
  const std::vector<BagTopic>& topics() const { return topics_; }
  const BagTopic* find(const std::string& topic) const { return findTopic(topics_, topic); }
  std::size_t messages(const BagHandlers& handlers) const;

  slam::Stamp begin() const { return begin_; }
  slam::Stamp end() const { return end_; }

  /// Calls the handlers, one for each topic, message by message. `progress` gets the number of
  /// messages that are done; the reading ends when it returns false.
  void read(const BagHandlers& handlers,
            const std::function<bool(std::size_t done)>& progress = {}) const;

  /// The name of the robot file, from the topic `robot`; empty if the bag does not have it.
  std::string robot() const;

 private:
  std::string path_;
  std::vector<BagTopic> topics_;
  slam::Stamp begin_, end_;
};

}  // namespace slam_ros
