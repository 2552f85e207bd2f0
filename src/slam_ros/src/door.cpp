// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/door.hpp"

#include <exception>
#include <new>

namespace slam_ros {

std::string faultIn(const Action& action) {
  try {
    action();
  } catch (const std::bad_alloc&) {
    return "there was not enough memory to process a message";
  } catch (const std::exception& error) {
    return std::string("a message could not be processed: ") + error.what();
  }
  return "";
}

std::string Door::pass(const std::string& topic, const Action& action) {
  if (!fault_.empty()) {
    ++refused_;
    return "";
  }
  const auto fault = faultIn(action);
  if (!fault.empty())
    fault_ = topic + ": " + fault + "; further messages are refused: reset or restart the node";
  return fault_;
}

}  // namespace slam_ros
