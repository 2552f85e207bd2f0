// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/ground_truth.hpp"

#include <fmt/format.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <slam_msgs/LandmarkMap.h>

#include <filesystem>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/product/run_writer.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

template <class Message>
bool has(const BagReader& bag, const std::string& topic) {
  const auto* found = bag.find(topic);
  return found != nullptr && found->messages > 0 &&
         found->md5sum == ros::message_traits::MD5Sum<Message>::value();
}

template <class Message, class Callback>
void readTopic(const BagReader& bag, const std::string& topic, Callback callback) {
  bag.read({{bag.find(topic)->name, onMessage<Message>(callback)}});
}

void replace(const std::string& path, const std::string& content) {
  std::error_code ignored;
  if (content.empty())
    std::filesystem::remove(path, ignored);
  else
    slam::writeFileAtomically(path, content);
}

/// A line of a trajectory; empty where the pose is no number.
std::string poseLine(slam::Stamp stamp, const geometry_msgs::Pose& message) {
  const auto pose = fromMsg(message);
  return pose.isFinite() ? slam::tumLine(stamp, pose) : "";
}

/// A true pose may have no heading: then its quaternion is zero, in the message and in the line.
std::string truthLine(slam::Stamp stamp, const geometry_msgs::Pose& message) {
  const auto& q = message.orientation;
  const auto position = fromMsg(message).position();
  const bool has_heading = q.x != 0.0 || q.y != 0.0 || q.z != 0.0 || q.w != 0.0;
  if (has_heading || !position.allFinite()) return poseLine(stamp, message);
  return slam::tumLineWithoutHeading(stamp, position);
}

/// The poses of a topic's messages, by `lineOf` a message; empty where the bag has none.
template <class Message, class LineOf>
std::string trajectory(const BagReader& bag, const std::string& topic, std::size_t& poses,
                       LineOf lineOf) {
  std::string text;
  if (!has<Message>(bag, topic)) return text;
  slam::Stamp last{};
  readTopic<Message>(bag, topic, [&](const auto& message) {
    const auto stamp = fromRos(message.header.stamp);
    const std::string line = lineOf(stamp, message);
    if (line.empty() || (poses > 0 && stamp <= last)) return;
    text += line;
    last = stamp;
    ++poses;
  });
  return text;
}

/// Which point of the robot the true positions are of, as a comment that the evaluation reads;
/// empty where it is the robot's frame itself.
std::string truePoint(const BagReader& bag) {
  const std::string topic = "/ground_truth/point";
  std::string text;
  if (has<geometry_msgs::PointStamped>(bag, topic))
    readTopic<geometry_msgs::PointStamped>(bag, topic, [&](const auto& message) {
      text = fmt::format("# point of the robot: {:.9f} {:.9f}\n", message.point.x, message.point.y);
    });
  return text;
}

std::string truePath(const BagReader& bag, std::size_t& poses) {
  const auto path = trajectory<geometry_msgs::PoseStamped>(
      bag, "/ground_truth/pose", poses,
      [](slam::Stamp stamp, const auto& message) { return truthLine(stamp, message.pose); });
  return path.empty() ? path : truePoint(bag) + path;
}

std::string mapText(const slam_msgs::LandmarkMap& map) {
  auto text =
      fmt::format("version: 1\nframe: {}\nunits: {{position: m, angle: rad}}\nlandmarks:{}\n",
                  frameId(map.header.frame_id), map.landmarks.empty() ? " []" : "");
  for (const auto& landmark : map.landmarks)
    text += fmt::format("  - {{id: {}, x: {}, y: {}, covariance: [{}]}}\n", landmark.id, landmark.x,
                        landmark.y, fmt::join(landmark.covariance, ", "));
  return text;
}

/// The table of stamps that an importer wrote beside the bag; empty where there is none.
std::string sourceStamps(const std::string& bag) {
  const auto path = bag + ".stamps.csv";
  return std::filesystem::exists(path) ? slam::readInputFile(path, "the bag's table of stamps")
                                       : "";
}

}  // namespace

GroundTruthCounts writeGroundTruth(const BagReader& bag, const std::string& folder) {
  GroundTruthCounts counts;
  const std::string topic = "/ground_truth/landmarks";
  std::string landmarks;
  if (has<slam_msgs::LandmarkMap>(bag, topic))
    readTopic<slam_msgs::LandmarkMap>(bag, topic, [&](const auto& map) {
      counts.landmarks = map.landmarks.size();
      landmarks = mapText(map);
    });
  replace(folder + "/ground_truth.tum", truePath(bag, counts.poses));
  replace(folder + "/ground_truth_landmarks.yaml", landmarks);
  replace(folder + "/stamps.csv", sourceStamps(bag.path()));
  return counts;
}

void writeWheelOdometry(const BagReader& bag, const std::string& folder) {
  std::size_t poses = 0;
  replace(folder + "/wheel_odometry.tum",
          trajectory<nav_msgs::Odometry>(bag, "odom", poses,
                                         [](slam::Stamp stamp, const auto& message) {
                                           return poseLine(stamp, message.pose.pose);
                                         }));
}

}  // namespace slam_ros
