// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/ground_truth.hpp"

#include <fmt/format.h>
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

/// The poses of a topic's messages, by `poseOf`; empty where the bag has none.
template <class Message, class PoseOf>
std::string trajectory(const BagReader& bag, const std::string& topic, std::size_t& poses,
                       PoseOf poseOf) {
  std::string text;
  if (!has<Message>(bag, topic)) return text;
  slam::Stamp last{};
  readTopic<Message>(bag, topic, [&](const auto& message) {
    const auto stamp = fromRos(message.header.stamp);
    const auto pose = fromMsg(poseOf(message));
    if (!pose.isFinite() || (poses > 0 && stamp <= last)) return;
    text += slam::tumLine(stamp, pose);
    last = stamp;
    ++poses;
  });
  return text;
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
  replace(folder + "/ground_truth.tum",
          trajectory<geometry_msgs::PoseStamped>(
              bag, "/ground_truth/pose", counts.poses,
              [](const auto& message) -> const auto& { return message.pose; }));
  replace(folder + "/ground_truth_landmarks.yaml", landmarks);
  replace(folder + "/stamps.csv", sourceStamps(bag.path()));
  return counts;
}

void writeWheelOdometry(const BagReader& bag, const std::string& folder) {
  std::size_t poses = 0;
  replace(folder + "/wheel_odometry.tum",
          trajectory<nav_msgs::Odometry>(
              bag, "odom", poses,
              [](const auto& message) -> const auto& { return message.pose.pose; }));
}

}  // namespace slam_ros
