// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_reader.hpp"

#include <std_msgs/String.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "slam_core/common/input_file.hpp"
#include "slam_ros/bag_process.hpp"
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
  if (!std::filesystem::exists(path)) fail(path, "there is no such file");
  if (const auto fault = slam::inputFileFault(path); !fault.empty()) fail(path, fault);
  try {
    const auto contents = contentsOfBag(path);
    topics_ = contents.topics;
    begin_ = fromRos(contents.begin);
    end_ = fromRos(contents.end);
  } catch (const std::exception& fault) {
    fail(path, fault.what());
  }
}

std::size_t BagReader::messages(const BagHandlers& handlers) const {
  std::size_t sum = 0;
  for (const auto& topic : topics_)
    if (handlers.count(topic.name) > 0) sum += topic.messages;
  return sum;
}

void BagReader::read(const BagHandlers& handlers,
                     const std::function<bool(std::size_t)>& progress) const {
  std::size_t done = 0;
  std::exception_ptr of_handler;
  const auto take = [&](const BagMessage& message) {
    try {
      handlers.at(message.topic)(message);
      return !progress || progress(++done);
    } catch (const ros::serialization::StreamOverrunException&) {
      throw std::runtime_error("it is damaged (a message is shorter than its type)");
    } catch (...) {
      of_handler = std::current_exception();  // no fault of the bag
      return false;
    }
  };
  try {
    readBag(path_, names(handlers), take);
  } catch (const std::exception& fault) {
    fail(path_, fault.what());
  }
  if (of_handler) std::rethrow_exception(of_handler);
}

std::string BagReader::robot() const {
  const auto* topic = find("robot");
  if (topic == nullptr || topic->type != "std_msgs/String") return "";
  std::string name;
  read({{topic->name, onMessage<std_msgs::String>([&](const auto& text) { name = text.data; })}});
  return name;
}

}  // namespace slam_ros
