// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <slam_msgs/LandmarkMap.h>

#include <cstdint>
#include <string>

#include "bag_writer.hpp"

namespace slam::eval {

inline constexpr char kOdometryTopic[] = "/odom";
inline constexpr char kObservationsTopic[] = "/observations";
inline constexpr char kTruthPoseTopic[] = "/ground_truth/pose";
/// Once, a geometry_msgs/PointStamped: the point of the robot whose true position is told. Without
/// it it is base_link.
inline constexpr char kTruthPointTopic[] = "/ground_truth/point";
inline constexpr char kTruthLandmarksTopic[] = "/ground_truth/landmarks";

/// @param stamp [ns]
ros::Time toTime(std::int64_t stamp);

/// Planar pose [m, m, rad] as a message.
geometry_msgs::Pose toPose(double x, double y, double theta);

/// Odometry message odom -> base_link with identity pose and zero twist. @param stamp [ns]
nav_msgs::Odometry makeOdometry(std::int64_t stamp);

/// True pose in the frame world [m, m, rad]. @param stamp [ns]
geometry_msgs::PoseStamped makeTruthPose(std::int64_t stamp, double x, double y, double theta);

/// True landmark [m], covariance zero.
slam_msgs::Landmark makeTruthLandmark(std::int64_t id, double x, double y);

/// Empty map in the frame world.
slam_msgs::LandmarkMap makeTruthMap();

/// First message of a bag: the name of its robot file.
void addRobotName(BagWriter& bag, const std::string& robot);

}  // namespace slam::eval
