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

/// The path that a bag shall go to cannot be one. One sentence.
class BagPathError : public WrongUse {
 public:
  using WrongUse::WrongUse;
};

/// Writing failed, and nothing is left of the bag. One sentence.
class BagWriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A bag that is written message by message and is there as a whole or not at all: a part of
/// its own beside it becomes PATH in complete(); without it, and after an error, the part is
/// removed.
class BagFile {
 public:
  /// @throw BagPathError its folder is not there, or it is no ordinary file; BagWriteError
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
