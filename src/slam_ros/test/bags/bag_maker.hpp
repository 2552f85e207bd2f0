// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <slam_msgs/LandmarkMap.h>
#include <slam_msgs/LandmarkObservationArray.h>
#include <slam_msgs/Motion.h>
#include <std_msgs/String.h>
#include <stdlib.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace slam_ros::test {

/// A folder of one test; gone with it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "slam_bags_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(*this / name) << content;
    return *this / name;
  }
  std::string read(const std::string& name) const {
    std::ostringstream content;
    content << std::ifstream(*this / name).rdbuf();
    return content.str();
  }
  bool has(const std::string& name) const { return std::filesystem::exists(*this / name); }

 private:
  std::string path_;
};

inline ros::Time at(double seconds) { return ros::Time(100.0 + seconds); }

/// A robot that drives ahead at 1 m/s past the landmarks (5, 2) with id 1 and (8, -2) with id 2.
inline nav_msgs::Odometry odometry(double t) {
  nav_msgs::Odometry message;
  message.header.stamp = at(t);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose.position.x = t;
  message.pose.pose.orientation.w = 1.0;
  return message;
}

inline slam_msgs::LandmarkObservationArray observations(double t, std::uint64_t sequence) {
  slam_msgs::LandmarkObservationArray message;
  message.header.stamp = at(t);
  message.header.frame_id = "base_link";
  message.sequence = sequence;
  const double landmarks[2][2] = {{5, 2}, {8, -2}};
  for (int id = 1; id <= 2; ++id) {
    const double dx = landmarks[id - 1][0] - t, dy = landmarks[id - 1][1];
    slam_msgs::LandmarkObservation seen;
    seen.id = id;
    seen.range = std::hypot(dx, dy);
    seen.bearing = std::atan2(dy, dx);
    seen.covariance = {0.01, 0, 0, 0.0004};
    message.observations.push_back(seen);
  }
  return message;
}

inline slam_msgs::Motion motion(double t, double dt, std::uint64_t sequence) {
  slam_msgs::Motion message;
  message.header.stamp = message.end = at(t + dt);
  message.start = at(t);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.sequence = sequence;
  message.increment.x = dt;
  message.covariance = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-5};
  message.odometry_start.x = t;
  message.odometry_end.x = t + dt;
  return message;
}

inline tf2_msgs::TFMessage transform(const std::string& parent, const std::string& child,
                                     double t) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  auto& edge = message.transforms.front();
  edge.header.stamp = at(t);
  edge.header.frame_id = parent;
  edge.child_frame_id = child;
  edge.transform.translation.x = t;
  edge.transform.rotation.w = 1.0;
  return message;
}

/// Writes a bag message by message.
class BagMaker {
 public:
  explicit BagMaker(const std::string& path) : bag_(path, rosbag::bagmode::Write) {}
  ~BagMaker() { bag_.close(); }

  template <class Message>
  BagMaker& add(const std::string& topic, double t, const Message& message) {
    bag_.write(topic, at(t), message);
    return *this;
  }
  BagMaker& addOdometry(const std::string& topic = "/odom", double duration = 4.0) {
    for (int i = 0; i <= 20 * duration; ++i) add(topic, 0.05 * i, odometry(0.05 * i));
    return *this;
  }
  BagMaker& addObservations(const std::string& topic = "/observations", double duration = 3.5) {
    for (int i = 1; i <= 5 * duration; ++i)
      add(topic, 0.2 * i, observations(0.2 * i, static_cast<std::uint64_t>(i - 1)));
    return *this;
  }
  BagMaker& addTruth() {
    for (int i = 0; i <= 40; ++i) {
      geometry_msgs::PoseStamped pose;
      pose.header.stamp = at(0.1 * i);
      pose.pose.position.x = 0.1 * i;
      pose.pose.orientation.w = 1.0;
      add("/ground_truth/pose", 0.1 * i, pose);
    }
    slam_msgs::LandmarkMap map;
    map.header.frame_id = "world";
    map.landmarks.resize(1);
    map.landmarks[0].id = 1;
    map.landmarks[0].x = 5.0;
    map.landmarks[0].y = 2.0;
    return add("/ground_truth/landmarks", 0, map);
  }
  BagMaker& addRobot(const std::string& name) {
    std_msgs::String message;
    message.data = name;
    return add("/robot", 0, message);
  }

 private:
  rosbag::Bag bag_;
};

/// What an action throws, or "" when it does not.
template <class Action>
std::string messageOf(Action&& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace slam_ros::test
