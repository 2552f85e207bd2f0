// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/Pose2D.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/TwistStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <slam_msgs/LandmarkMap.h>
#include <slam_msgs/LandmarkObservationArray.h>
#include <slam_msgs/Motion.h>

#include <string>

#include "slam_core/imu/imu_reading.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/models/velocity_command.hpp"

namespace slam_ros {

slam::Stamp fromRos(const ros::Time& time);
/// Times before 1970 or after 2106 cannot be represented: they become the nearest time that can.
ros::Time toRos(slam::Stamp stamp);

/// The frame's name without the leading slash of tf's first generation.
std::string frameId(const std::string& name);

geometry_msgs::Pose2D toMsg(const slam::Pose2& pose);
/// The pose in space: z = 0, rotated about +z.
geometry_msgs::Pose toSpatialMsg(const slam::Pose2& pose);
geometry_msgs::Transform toTransformMsg(const slam::Pose2& pose);
slam::Pose2 fromMsg(const geometry_msgs::Pose2D& pose);
/// The horizontal part; the heading is NaN if the quaternion is not valid.
slam::Pose2 fromMsg(const geometry_msgs::Pose& pose);

/// Why the message's pose cannot be used, so that its twist is used instead, as a clause; empty if
/// it can. A quaternion must be of unit length within 0.1.
std::string poseFault(const nav_msgs::Odometry& message);
/// Whether the driver declares that it gives no pose (pose.covariance[0] is -1).
bool saysNoPose(const nav_msgs::Odometry& message);
/// Its pose is left out if poseFault() or saysNoPose().
slam::OdometrySample fromMsg(const nav_msgs::Odometry& message);
slam::VelocityCommand fromMsg(const geometry_msgs::TwistStamped& message);

slam_msgs::Motion toMsg(const slam::Motion& motion);
slam::Motion fromMsg(const slam_msgs::Motion& message);

slam_msgs::LandmarkObservationArray toMsg(const slam::LandmarkObservationArray& array);
slam::LandmarkObservationArray fromMsg(const slam_msgs::LandmarkObservationArray& message);

/// Its intensities are not used.
slam::LaserSweep fromMsg(const sensor_msgs::LaserScan& message);

/// Its orientation and accelerations are not used.
slam::ImuReading fromMsg(const sensor_msgs::Imu& message);

slam_msgs::LandmarkMap toMsg(const slam::LandmarkMap& landmarks, slam::Stamp stamp,
                             const std::string& frame);

geometry_msgs::PoseWithCovarianceStamped toMsg(const slam::PoseEstimate& estimate,
                                               slam::Stamp stamp, const std::string& frame);
slam::PoseEstimate fromMsg(const geometry_msgs::PoseWithCovarianceStamped& message);

}  // namespace slam_ros
