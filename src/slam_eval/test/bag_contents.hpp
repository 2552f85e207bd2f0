// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <string>
#include <vector>

namespace slam::eval {

/// All messages of one topic of a bag, in bag order.
template <class Message>
std::vector<Message> messagesOf(const std::string& path, const std::string& topic) {
  rosbag::Bag bag(path);
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  std::vector<Message> messages;
  for (const rosbag::MessageInstance& instance : view) {
    if (const auto message = instance.instantiate<Message>()) messages.push_back(*message);
  }
  return messages;
}

}  // namespace slam::eval
