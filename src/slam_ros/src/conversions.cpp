// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/conversions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slam_ros {
namespace {

/// Of (x, y, theta) in a row-major 6x6 covariance of (x, y, z, roll, pitch, yaw).
constexpr std::size_t kPlanar[] = {0, 1, 5};

template <class Array>
Eigen::Matrix3d planarCovariance(const Array& covariance) {
  Eigen::Matrix3d planar;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      planar(row, column) = covariance[6 * kPlanar[row] + kPlanar[column]];
  return planar;
}

template <int N, class Array>
Eigen::Matrix<double, N, N> squareMatrix(const Array& values) {
  return Eigen::Map<const Eigen::Matrix<double, N, N, Eigen::RowMajor>>(values.data());
}

template <int N, class Array>
void copyTo(const Eigen::Matrix<double, N, N>& matrix, Array& values) {
  Eigen::Map<Eigen::Matrix<double, N, N, Eigen::RowMajor>>(values.data()) = matrix;
}

/// A descriptor that is too long stays too long by one element, so that it is refused.
slam::Descriptor::Vector descriptorVector(const std::vector<float>& values) {
  constexpr std::size_t kRoom = slam::Descriptor::kMostElements + 1;
  const auto size = static_cast<Eigen::Index>(std::min(values.size(), kRoom));
  return Eigen::Map<const Eigen::VectorXf>(values.data(), size);
}

template <class Message>
void copyDescriptor(const slam::Descriptor& descriptor, Message& message) {
  const auto& [values, sigmas] = descriptor;
  message.descriptor.assign(values.data(), values.data() + values.size());
  message.descriptor_sigma.assign(sigmas.data(), sigmas.data() + sigmas.size());
}

double norm(const geometry_msgs::Quaternion& q) {
  return std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
}

/// [rad]; independent of the quaternion's length
double yaw(const geometry_msgs::Quaternion& q) {
  if (norm(q) == 0.0) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

geometry_msgs::Quaternion aboutZ(double theta) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(theta / 2);
  q.w = std::cos(theta / 2);
  return q;
}

}  // namespace

slam::Stamp fromRos(const ros::Time& time) {
  return slam::stampFromNanoseconds(static_cast<std::int64_t>(time.toNSec()));
}

ros::Time toRos(slam::Stamp stamp) {
  constexpr std::int64_t kLast = 4294967295LL * 1000000000LL;
  ros::Time time;
  time.fromNSec(
      static_cast<std::uint64_t>(std::clamp<std::int64_t>(slam::nanoseconds(stamp), 0, kLast)));
  return time;
}

std::string frameId(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

geometry_msgs::Pose2D toMsg(const slam::Pose2& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x();
  message.y = pose.y();
  message.theta = pose.theta();
  return message;
}

geometry_msgs::Pose toSpatialMsg(const slam::Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x();
  message.position.y = pose.y();
  message.orientation = aboutZ(pose.theta());
  return message;
}

geometry_msgs::Transform toTransformMsg(const slam::Pose2& pose) {
  geometry_msgs::Transform message;
  message.translation.x = pose.x();
  message.translation.y = pose.y();
  message.rotation = aboutZ(pose.theta());
  return message;
}

slam::Pose2 fromMsg(const geometry_msgs::Pose2D& pose) { return {pose.x, pose.y, pose.theta}; }

slam::Pose2 fromMsg(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y, yaw(pose.orientation)};
}

bool saysNoPose(const nav_msgs::Odometry& message) { return message.pose.covariance[0] == -1.0; }

std::string poseFault(const nav_msgs::Odometry& message) {
  const double length = norm(message.pose.pose.orientation);
  if (length == 0.0) return "the quaternion of its pose is zero";
  // not a number goes on to the component, which rejects the whole message
  if (std::abs(length - 1.0) > 0.1) return "the quaternion of its pose is not of unit length";
  return "";
}

slam::OdometrySample fromMsg(const nav_msgs::Odometry& message) {
  slam::OdometrySample sample;
  sample.stamp = fromRos(message.header.stamp);
  if (!saysNoPose(message) && poseFault(message).empty()) sample.pose = fromMsg(message.pose.pose);
  const auto& twist = message.twist.twist;
  sample.twist << twist.linear.x, twist.linear.y, twist.angular.z;
  sample.twist_covariance = planarCovariance(message.twist.covariance);
  sample.odometry_frame = frameId(message.header.frame_id);
  sample.base_frame = frameId(message.child_frame_id);
  return sample;
}

slam::VelocityCommand fromMsg(const geometry_msgs::TwistStamped& message) {
  const auto& twist = message.twist;
  return {fromRos(message.header.stamp), {twist.linear.x, twist.linear.y, twist.angular.z}};
}

slam_msgs::Motion toMsg(const slam::Motion& motion) {
  slam_msgs::Motion message;
  message.header.stamp = toRos(motion.end);
  message.header.frame_id = motion.odometry_frame;
  message.child_frame_id = motion.base_frame;
  message.sequence = motion.sequence;
  message.start = toRos(motion.start);
  message.end = toRos(motion.end);
  message.increment = toMsg(motion.increment);
  copyTo<3>(motion.covariance, message.covariance);
  message.odometry_start = toMsg(motion.odometry_start);
  message.odometry_end = toMsg(motion.odometry_end);
  return message;
}

slam::Motion fromMsg(const slam_msgs::Motion& message) {
  slam::Motion motion;
  motion.sequence = message.sequence;
  motion.start = fromRos(message.start);
  motion.end = fromRos(message.end);
  motion.increment = fromMsg(message.increment);
  motion.covariance = squareMatrix<3>(message.covariance);
  motion.odometry_start = fromMsg(message.odometry_start);
  motion.odometry_end = fromMsg(message.odometry_end);
  motion.odometry_frame = frameId(message.header.frame_id);
  motion.base_frame = frameId(message.child_frame_id);
  return motion;
}

slam_msgs::LandmarkObservationArray toMsg(const slam::LandmarkObservationArray& array) {
  slam_msgs::LandmarkObservationArray message;
  message.header.stamp = toRos(array.stamp);
  message.header.frame_id = array.sensor_frame;
  message.sequence = array.sequence;
  message.sensor_pose = toMsg(array.sensor_pose);
  for (const auto& observation : array.observations) {
    slam_msgs::LandmarkObservation entry;
    entry.id = observation.id;
    entry.range = observation.range;
    entry.bearing = observation.bearing;
    copyTo<2>(observation.covariance, entry.covariance);
    entry.kind = static_cast<std::uint8_t>(observation.kind);
    entry.begin = observation.extent.begin;
    entry.end = observation.extent.end;
    copyDescriptor(observation.descriptor, entry);
    message.observations.push_back(entry);
  }
  return message;
}

slam::LandmarkObservationArray fromMsg(const slam_msgs::LandmarkObservationArray& message) {
  slam::LandmarkObservationArray array;
  array.sequence = message.sequence;
  array.stamp = fromRos(message.header.stamp);
  array.sensor_frame = frameId(message.header.frame_id);
  array.sensor_pose = fromMsg(message.sensor_pose);
  for (const auto& entry : message.observations) {
    slam::LandmarkObservation observation;
    observation.id = entry.id;
    observation.range = entry.range;
    observation.bearing = entry.bearing;
    observation.covariance = squareMatrix<2>(entry.covariance);
    observation.kind = static_cast<slam::LandmarkKind>(entry.kind);
    observation.extent = {entry.begin, entry.end};
    observation.descriptor = {descriptorVector(entry.descriptor),
                              descriptorVector(entry.descriptor_sigma)};
    array.observations.push_back(observation);
  }
  return array;
}

slam::LaserSweep fromMsg(const sensor_msgs::LaserScan& message) {
  slam::LaserSweep sweep;
  sweep.stamp = fromRos(message.header.stamp);
  sweep.frame = frameId(message.header.frame_id);
  sweep.angle_min = message.angle_min;
  sweep.angle_max = message.angle_max;
  sweep.angle_increment = message.angle_increment;
  sweep.range_min = message.range_min;
  sweep.range_max = message.range_max;
  sweep.ranges = message.ranges;
  sweep.intensities = message.intensities;
  return sweep;
}

slam::ImuReading fromMsg(const sensor_msgs::Imu& message) {
  const auto& rate = message.angular_velocity;
  slam::ImuReading reading;
  reading.stamp = fromRos(message.header.stamp);
  reading.frame = frameId(message.header.frame_id);
  reading.angular_velocity = {rate.x, rate.y, rate.z};
  reading.covariance = squareMatrix<3>(message.angular_velocity_covariance);
  return reading;
}

slam_msgs::LandmarkMap toMsg(const slam::LandmarkMap& landmarks, slam::Stamp stamp,
                             const std::string& frame) {
  slam_msgs::LandmarkMap message;
  message.header.stamp = toRos(stamp);
  message.header.frame_id = frame;
  for (const auto& landmark : landmarks) {
    slam_msgs::Landmark entry;
    entry.id = landmark.id;
    entry.x = landmark.position.x();
    entry.y = landmark.position.y();
    copyTo<2>(landmark.covariance, entry.covariance);
    entry.kind = static_cast<std::uint8_t>(landmark.kind);
    entry.direction = landmark.direction;
    entry.begin = landmark.extent.begin;
    entry.end = landmark.extent.end;
    copyDescriptor(landmark.descriptor, entry);
    message.landmarks.push_back(entry);
  }
  return message;
}

geometry_msgs::PoseWithCovarianceStamped toMsg(const slam::PoseEstimate& estimate,
                                               slam::Stamp stamp, const std::string& frame) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.stamp = toRos(stamp);
  message.header.frame_id = frame;
  message.pose.pose = toSpatialMsg(estimate.pose);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      message.pose.covariance[6 * kPlanar[row] + kPlanar[column]] =
          estimate.covariance(row, column);
  return message;
}

slam::PoseEstimate fromMsg(const geometry_msgs::PoseWithCovarianceStamped& message) {
  return {fromMsg(message.pose.pose), planarCovariance(message.pose.covariance)};
}

}  // namespace slam_ros
