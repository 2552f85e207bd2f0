// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_reader.hpp"

#include <std_msgs/String.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& fault) {
  throw std::runtime_error("cannot read the bag " + path + ": " + fault);
}

std::vector<std::string> names(const BagHandlers& handlers) {
  std::vector<std::string> topics;
  for (const auto& entry : handlers) topics.push_back(entry.first);
  return topics;
}

}  // namespace

BagReader::BagReader(const std::string& path) : path_(path) {
  open();
  listTopics();
}

void BagReader::open() {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path_, error)) fail(path_, "there is no such file");
  if (fs::is_directory(path_, error)) fail(path_, "it is a folder");
  try {
    bag_.open(path_, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    fail(path_, "it has no index, as if its recording was cut off; `rosbag reindex` may save it");
  } catch (const rosbag::BagFormatException&) {
    fail(path_, "it is not a bag");
  } catch (const rosbag::BagIOException& fault) {
    fail(path_, std::string("it is not a bag, or its end is missing (") + fault.what() + ")");
  } catch (const ros::Exception& fault) {
    fail(path_, fault.what());
  }
}

void BagReader::listTopics() {
  rosbag::View all(bag_);
  if (all.size() == 0) return;
  begin_ = fromRos(all.getBeginTime());
  end_ = fromRos(all.getEndTime());
  for (const auto* connection : all.getConnections()) {
    if (find(connection->topic) != nullptr) continue;  // one of several publishers
    rosbag::View view(bag_, rosbag::TopicQuery(connection->topic));
    topics_.push_back({connection->topic, connection->datatype, connection->md5sum, view.size()});
  }
  std::sort(topics_.begin(), topics_.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
}

const BagTopic* BagReader::find(const std::string& topic) const {
  const auto found = std::find_if(topics_.begin(), topics_.end(),
                                  [&](const auto& entry) { return sameTopic(entry.name, topic); });
  return found == topics_.end() ? nullptr : &*found;
}

std::size_t BagReader::messages(const BagHandlers& handlers) const {
  std::size_t sum = 0;
  for (const auto& topic : topics_)
    if (handlers.count(topic.name) > 0) sum += topic.messages;
  return sum;
}

void BagReader::read(const BagHandlers& handlers,
                     const std::function<bool(std::size_t)>& progress) const {
  try {
    rosbag::View view(bag_, rosbag::TopicQuery(names(handlers)));
    std::size_t done = 0;
    for (const auto& message : view) {
      handlers.at(message.getTopic())(message);
      if (progress && !progress(++done)) return;
    }
  } catch (const rosbag::BagException& fault) {
    fail(path_, std::string("it is damaged (") + fault.what() + ")");
  } catch (const ros::serialization::StreamOverrunException&) {
    fail(path_, "it is damaged (a message is shorter than its type)");
  }
}

std::string BagReader::robot() const {
  const auto* topic = find("robot");
  if (topic == nullptr || topic->type != "std_msgs/String") return "";
  std::string name;
  read({{topic->name, onMessage<std_msgs::String>([&](const auto& text) { name = text.data; })}});
  return name;
}

}  // namespace slam_ros
