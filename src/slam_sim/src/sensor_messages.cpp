// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sensor_messages.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "slam_ros/conversions.hpp"

namespace slam::sim {
namespace {

constexpr int kJpegQuality = 80;
constexpr double kGravity = 9.81;  // [m/s^2]

geometry_msgs::TransformStamped mount(const std::string& parent, const std::string& child,
                                      const ros::Time& stamp, const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  geometry_msgs::TransformStamped edge;
  edge.header.stamp = stamp;
  edge.header.frame_id = parent;
  edge.child_frame_id = child;
  edge.transform.translation.x = T.translation().x();
  edge.transform.translation.y = T.translation().y();
  edge.transform.translation.z = T.translation().z();
  edge.transform.rotation.x = q.x();
  edge.transform.rotation.y = q.y();
  edge.transform.rotation.z = q.z();
  edge.transform.rotation.w = q.w();
  return edge;
}

}  // namespace

nav_msgs::Odometry odometryMessage(const RobotModel& robot, const ros::Time& stamp,
                                   const Pose2& T_odom_base, const Eigen::Vector3d& velocity) {
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = robot.odom_frame;
  message.child_frame_id = robot.base_frame;
  message.pose.pose = slam_ros::toSpatialMsg(T_odom_base);
  message.twist.twist.linear.x = velocity.x();
  message.twist.twist.linear.y = velocity.y();
  message.twist.twist.angular.z = velocity.z();
  return message;
}

tf2_msgs::TFMessage transformMessage(const nav_msgs::Odometry& odometry) {
  geometry_msgs::TransformStamped edge;
  edge.header = odometry.header;
  edge.child_frame_id = odometry.child_frame_id;
  edge.transform.translation.x = odometry.pose.pose.position.x;
  edge.transform.translation.y = odometry.pose.pose.position.y;
  edge.transform.rotation = odometry.pose.pose.orientation;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(edge);
  return message;
}

tf2_msgs::TFMessage mountMessage(const RobotModel& robot, const ros::Time& stamp) {
  tf2_msgs::TFMessage message;
  const auto add = [&](const LaserModel& laser) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = laser.position;
    pose.linear() = Eigen::AngleAxisd(laser.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    message.transforms.push_back(mount(robot.base_frame, laser.frame, stamp, pose));
  };
  add(robot.laser);
  if (robot.rear_laser) add(*robot.rear_laser);
  if (robot.imu)
    message.transforms.push_back(
        mount(robot.base_frame, robot.imu->frame, stamp, robot.imu->T_base_imu));
  for (const auto& camera : robot.cameras) {
    message.transforms.push_back(
        mount(robot.base_frame, camera.link_frame, stamp, camera.T_base_link));
    message.transforms.push_back(
        mount(camera.link_frame, camera.optical_frame, stamp, CameraModel::linkToOptical()));
  }
  return message;
}

sensor_msgs::LaserScan scanMessage(const LaserModel& laser, const ros::Time& stamp,
                                   LaserReadings readings) {
  sensor_msgs::LaserScan message;
  message.header.stamp = stamp;
  message.header.frame_id = laser.frame;
  message.angle_min = static_cast<float>(laser.angle(0));
  message.angle_max = static_cast<float>(laser.angle(laser.beams - 1));
  message.angle_increment = static_cast<float>(laser.increment());
  message.scan_time = static_cast<float>(1.0 / laser.pace.rate);
  message.range_min = static_cast<float>(laser.min_range);
  message.range_max = static_cast<float>(laser.max_range);
  message.ranges = std::move(readings.ranges);
  message.intensities = std::move(readings.intensities);
  return message;
}

geometry_msgs::TwistStamped commandMessage(const RobotModel& robot, const ros::Time& stamp,
                                           const Eigen::Vector3d& twist) {
  geometry_msgs::TwistStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = robot.base_frame;
  message.twist.linear.x = twist.x();
  message.twist.linear.y = twist.y();
  message.twist.angular.z = twist.z();
  return message;
}

sensor_msgs::Imu imuMessage(const ImuModel& imu, const ros::Time& stamp,
                            const Eigen::Vector3d& rate) {
  const Eigen::Vector3d up = kGravity * imu.T_base_imu.linear().row(2);
  const double variance = imu.gyro_noise * imu.gyro_noise * imu.pace.rate;
  sensor_msgs::Imu message;
  message.header.stamp = stamp;
  message.header.frame_id = imu.frame;
  message.orientation_covariance[0] = -1.0;  // REP-145: there is none
  message.angular_velocity.x = rate.x();
  message.angular_velocity.y = rate.y();
  message.angular_velocity.z = rate.z();
  message.angular_velocity_covariance = {variance, 0, 0, 0, variance, 0, 0, 0, variance};
  message.linear_acceleration.x = up.x();
  message.linear_acceleration.y = up.y();
  message.linear_acceleration.z = up.z();
  return message;
}

sensor_msgs::CameraInfo cameraInfoMessage(const CameraModel& camera, const ros::Time& stamp) {
  const auto& c = camera.calibration;
  sensor_msgs::CameraInfo message;
  message.header.stamp = stamp;
  message.header.frame_id = camera.optical_frame;
  message.width = static_cast<std::uint32_t>(c.width);
  message.height = static_cast<std::uint32_t>(c.height);
  message.distortion_model = c.distortion_model;
  message.D = c.distortion;
  message.K = {c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0};
  message.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  message.P = {c.fx, 0.0, c.cx, 0.0, 0.0, c.fy, c.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return message;
}

sensor_msgs::Image imageMessage(const CameraModel& camera, const ros::Time& stamp,
                                const cv::Mat& gray) {
  sensor_msgs::Image message;
  message.header.stamp = stamp;
  message.header.frame_id = camera.optical_frame;
  message.width = static_cast<std::uint32_t>(gray.cols);
  message.height = static_cast<std::uint32_t>(gray.rows);
  message.encoding = "mono8";
  message.step = message.width;
  const cv::Mat pixels = gray.isContinuous() ? gray : gray.clone();
  message.data.assign(pixels.datastart, pixels.dataend);
  return message;
}

sensor_msgs::CompressedImage compressedMessage(const CameraModel& camera, const ros::Time& stamp,
                                               const cv::Mat& gray) {
  sensor_msgs::CompressedImage message;
  message.header.stamp = stamp;
  message.header.frame_id = camera.optical_frame;
  message.format = "mono8; jpeg compressed mono8";
  cv::imencode(".jpg", gray, message.data, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  return message;
}

geometry_msgs::PoseStamped truthMessage(const ros::Time& stamp, const Pose2& T_world_base) {
  geometry_msgs::PoseStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = kWorldFrame;
  message.pose = slam_ros::toSpatialMsg(T_world_base);
  return message;
}

slam_msgs::LandmarkMap truthMapMessage(const World& world, const ros::Time& stamp) {
  slam_msgs::LandmarkMap message;
  message.header.stamp = stamp;
  message.header.frame_id = kWorldFrame;
  for (const auto& marker : world.markers) {
    slam_msgs::Landmark landmark;
    landmark.id = marker.landmark();
    landmark.x = marker.T_world_marker.translation().x();
    landmark.y = marker.T_world_marker.translation().y();
    message.landmarks.push_back(landmark);
  }
  std::sort(message.landmarks.begin(), message.landmarks.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  return message;
}

}  // namespace slam::sim
