// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/cell_messages.hpp"

#include "slam_ros/conversions.hpp"

namespace slam_ros {

slam_msgs::ViewCell toMsg(const slam::rat::ViewCell& view) {
  slam_msgs::ViewCell message;
  message.header.stamp = toRos(view.stamp);
  message.sequence = view.sequence;
  message.cell = view.cell;
  message.is_new = view.is_new;
  message.difference = view.difference;
  return message;
}

slam::rat::ViewCell fromMsg(const slam_msgs::ViewCell& message) {
  return {fromRos(message.header.stamp), message.sequence, message.cell, message.is_new != 0,
          message.difference};
}

slam_msgs::PoseCellState toMsg(const slam::rat::PoseCellState& state) {
  slam_msgs::PoseCellState message;
  message.header.stamp = toRos(state.stamp);
  message.sequence = state.sequence;
  message.x = state.place.x;
  message.y = state.place.y;
  message.theta = state.place.theta;
  message.view = state.view;
  message.edge = state.edge;
  message.headings = state.headings;
  return message;
}

slam::rat::PoseCellState fromMsg(const slam_msgs::PoseCellState& message) {
  return {fromRos(message.header.stamp),
          message.sequence,
          {message.x, message.y, message.theta},
          message.view,
          message.edge,
          message.headings};
}

}  // namespace slam_ros
