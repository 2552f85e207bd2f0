// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <slam_msgs/LandmarkMap.h>
#include <tf2_msgs/TFMessage.h>

#include <opencv2/core/mat.hpp>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_sim/robot_model.hpp"
#include "slam_sim/world.hpp"

namespace slam::sim {

/// The frame of the ground truth.
inline constexpr char kWorldFrame[] = "world";

/// @param velocity measured body twist (vx, vy, omega) [m/s, m/s, rad/s]
nav_msgs::Odometry odometryMessage(const RobotModel& robot, const ros::Time& stamp,
                                   const Pose2& T_odom_base, const Eigen::Vector3d& velocity);
/// The same pose as the transform odom -> base.
tf2_msgs::TFMessage transformMessage(const nav_msgs::Odometry& odometry);
/// Where the sensors are mounted.
tf2_msgs::TFMessage mountMessage(const RobotModel& robot, const ros::Time& stamp);

sensor_msgs::LaserScan scanMessage(const LaserModel& laser, const ros::Time& stamp,
                                   LaserReadings readings);
/// @param twist (vx, vy, omega) in the base [m/s, m/s, rad/s]
geometry_msgs::TwistStamped commandMessage(const RobotModel& robot, const ros::Time& stamp,
                                           const Eigen::Vector3d& twist);

/// Without orientation. @param rate measured, in the IMU's frame [rad/s]
sensor_msgs::Imu imuMessage(const ImuModel& imu, const ros::Time& stamp,
                            const Eigen::Vector3d& rate);
sensor_msgs::CameraInfo cameraInfoMessage(const CameraModel& camera, const ros::Time& stamp);
/// mono8
sensor_msgs::Image imageMessage(const CameraModel& camera, const ros::Time& stamp,
                                const cv::Mat& gray);
/// mono8 as JPEG of quality 80
sensor_msgs::CompressedImage compressedMessage(const CameraModel& camera, const ros::Time& stamp,
                                               const cv::Mat& gray);

geometry_msgs::PoseStamped truthMessage(const ros::Time& stamp, const Pose2& T_world_base);
/// The markers as point landmarks, sorted by id.
slam_msgs::LandmarkMap truthMapMessage(const World& world, const ros::Time& stamp);

}  // namespace slam::sim
