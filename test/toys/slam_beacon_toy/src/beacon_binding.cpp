// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <slam_beacon_toy/BeaconRanges.h>

#include <slam_ros/conversions.hpp>
#include <slam_ros/message_binding.hpp>

#include "beacon_ranges.hpp"

// How ranges to beacons come from a topic and from a bag: a library of its own, which the product
// names, so that the component needs no ROS.

namespace slam_toy {
namespace {

BeaconRanges fromMsg(const slam_beacon_toy::BeaconRanges& message) {
  return {message.sequence, slam_ros::fromRos(message.header.stamp), message.ids, message.ranges,
          message.sigma};
}

const slam_ros::MessageBindingRegistrar<slam_beacon_toy::BeaconRanges, BeaconRanges, fromMsg>
    kRegistrar;

}  // namespace
}  // namespace slam_toy
