// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/progress.hpp"
#include "slam_ros/bag_file.hpp"

namespace slam::eval {

/// Holds an import's messages, and writes them in stamp order as one rosbag.
///
/// Messages of equal stamp are written in the order they were added; the messages of a log's start
/// (addFirst) come before all others, some nanoseconds before the earliest stamp: readers of a bag
/// do not keep the order of equal receive times. The receive time is the stamp.
class BagWriter {
 public:
  /// A message that has no stamp of its own, e.g. the name of the robot file.
  template <class Message>
  void addFirst(const std::string& topic, const Message& message) {
    first_.push_back({ros::Time(), writer(topic, message)});
  }

  /// A message like the one above, with a header that takes its receive time.
  template <class Message>
  void addFirstStamped(const std::string& topic, Message message) {
    first_.push_back(
        {ros::Time(), [topic, message](slam_ros::BagFile& bag, const ros::Time& t) mutable {
           message.header.stamp = t;
           bag.write(topic, t, message);
         }});
  }

  template <class Message>
  void add(const std::string& topic, const Message& message) {
    entries_.push_back({message.header.stamp, writer(topic, message)});
  }

  /// A text that belongs to the bag and is written beside it, as PATH + ending.
  void addBeside(const std::string& ending, std::string text) {
    beside_.push_back({ending, std::move(text)});
  }

  /// Number of messages added.
  std::size_t size() const { return first_.size() + entries_.size(); }

  /// From the first to the last stamp [s].
  double duration() const;

  /// Writes a part beside PATH and renames it to PATH when it and what belongs beside it are
  /// complete: there is never a half bag.
  /// @throw UsageError PATH's folder is not there or PATH is no file; ImportError no messages, or
  /// writing failed
  void write(const std::string& path, Progress& progress);

 private:
  using Writer = std::function<void(slam_ros::BagFile&, const ros::Time&)>;
  struct Entry {
    ros::Time stamp;
    Writer write;
  };

  template <class Message>
  static Writer writer(const std::string& topic, const Message& message) {
    return [topic, message](slam_ros::BagFile& bag, const ros::Time& t) {
      bag.write(topic, t, message);
    };
  }

  void writeMessages(slam_ros::BagFile& bag, Progress& progress) const;
  void writeBeside(const std::string& path) const;

  std::vector<Entry> first_;
  std::vector<Entry> entries_;
  std::vector<std::pair<std::string, std::string>> beside_;
};

}  // namespace slam::eval
