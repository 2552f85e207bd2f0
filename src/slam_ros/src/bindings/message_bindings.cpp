// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include "slam_core/models/filter_pose.hpp"
#include "slam_core/models/velocity_command.hpp"
#include "slam_ros/cell_messages.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/message_binding.hpp"

// Kinds of data that are messages of one topic, as the components of a product exchange them.

namespace slam_ros {
namespace {

slam::FilterPose filterPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const auto& pose = message.pose.pose;
  return {fromRos(message.header.stamp), pose.position.x, pose.position.y, pose.orientation.z,
          pose.orientation.w};
}

using StampedTwistInBag = MessageInBag<geometry_msgs::TwistStamped, slam::VelocityCommand, fromMsg>;

/// Many robots record commands without stamps.
class CommandsInBag final : public StampedTwistInBag {
 public:
  using StampedTwistInBag::StampedTwistInBag;
  std::string need() const override {
    return StampedTwistInBag::need() + "; a geometry_msgs/Twist has no stamp";
  }
};

const MessageBindingRegistrar<slam_msgs::Motion, slam::Motion, fromMsg> kMotion;
const MessageBindingRegistrar<geometry_msgs::TwistStamped, slam::VelocityCommand, fromMsg,
                              CommandsInBag>
    kCommands;
const MessageBindingRegistrar<slam_msgs::LandmarkObservationArray, slam::LandmarkObservationArray,
                              fromMsg>
    kObservations;
const MessageBindingRegistrar<geometry_msgs::PoseWithCovarianceStamped, slam::FilterPose,
                              filterPose>
    kPose;
const MessageBindingRegistrar<slam_msgs::ViewCell, slam::rat::ViewCell, fromMsg> kViewCell;
const MessageBindingRegistrar<slam_msgs::PoseCellState, slam::rat::PoseCellState, fromMsg>
    kPoseCellState;

}  // namespace
}  // namespace slam_ros
