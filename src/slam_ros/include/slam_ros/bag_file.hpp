// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>

#include <cerrno>
#include <memory>
#include <stdexcept>
#include <string>

#include "slam_ros/wrong_use.hpp"

namespace slam_ros {

/// A bag cannot be written to this path. The message is one sentence.
class BagPathError : public WrongUse {
 public:
  using WrongUse::WrongUse;
};

/// Writing failed, and nothing is left of the bag. The message is one sentence.
class BagWriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A bag that is written message by message, and exists either completely or not at all: it is
/// written to a file beside PATH, which complete() renames to PATH. Without complete(), and after
/// an error, this file is removed.
class BagFile {
 public:
  /// @throw BagPathError if its folder does not exist, or it is not an ordinary file; BagWriteError
  explicit BagFile(const std::string& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// @param time of receipt @throw BagWriteError
  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    guarded([&] { bag_->write(topic, time, message); });
  }

  /// @throw BagWriteError
  void complete();

 private:
  template <class Action>
  void guarded(Action&& action) {
    errno = 0;
    try {
      action();
    } catch (const std::exception&) {
      fail(errno);
    }
  }

  [[noreturn]] void fail(int error);
  void abandon();

  std::string path_, part_;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace slam_ros
