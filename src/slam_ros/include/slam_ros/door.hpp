// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace slam_ros {

using Action = std::function<void()>;

/// Calls a function. @return one sentence about the exception that it threw; empty if there was
/// none
std::string faultIn(const Action& action);

/// Protects a nodelet whose state must not be half changed: an exception of a callback shuts the
/// door, and further input is refused and counted until open(). For one thread.
class Door {
 public:
  /// @return one sentence about the exception that shut the door in this call; otherwise empty
  std::string pass(const std::string& topic, const Action& action);
  void open() { fault_.clear(); }

  /// Why the door is shut; empty while it is open.
  const std::string& fault() const { return fault_; }
  std::uint64_t refused() const { return refused_; }

 private:
  std::string fault_;
  std::uint64_t refused_ = 0;
};

/// The wrapper through which callbacks are called, so that no exception leaves them: it would end
/// the manager with all nodelets. (topic, what the callback does)
using Pass = std::function<void(const std::string& topic, const Action& action)>;

/// Recognises a message that comes a second time. roscpp connects a subscription twice to a
/// publisher of the same process if one thread subscribes while another one advertises; each
/// message then comes twice, as the same object.
class LastMessage {
 public:
  /// Whether this is another message than that of the last call.
  bool isNew(const boost::shared_ptr<const void>& message) {
    return std::exchange(last_, message) != message;
  }

 private:
  boost::shared_ptr<const void> last_;  ///< it is kept, so that no other message has its address
};

/// A subscription whose callbacks go through `pass`, once for each message.
template <class Message, class Take>
ros::Subscriber subscribeThrough(Pass pass, ros::NodeHandle handle, const std::string& topic,
                                 std::uint32_t queue, Take take) {
  using Pointer = boost::shared_ptr<const Message>;
  const boost::function<void(const Pointer&)> callback =
      [pass = std::move(pass), topic, take = std::move(take),
       last = LastMessage()](const Pointer& message) mutable {
        if (last.isNew(message)) pass(topic, [&] { take(*message); });
      };
  return handle.subscribe<Message>(topic, queue, callback);
}

}  // namespace slam_ros
