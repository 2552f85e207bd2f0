// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_process.hpp"

#include <console_bridge/console.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "slam_core/common/child_process.hpp"
#include "slam_ros/earlier_messages.hpp"

namespace slam_ros {
namespace {

enum class Kind : std::uint32_t { kText, kNumber, kMessage, kFault, kEnd };

/// Before each piece that crosses.
struct PieceHeader {
  Kind kind = Kind::kEnd;
  std::uint32_t size = 0;  // [B] of what follows
  std::uint32_t topic = 0;
  ros::Time time;
};

/// In the child: nobody reads on where writing fails, so it ends.
class PieceWriter {
 public:
  explicit PieceWriter(int output) : output_(output) {}

  void write(const PieceHeader& header, const void* content) const {
    if (!slam::writeAll(output_, &header, sizeof(header)) ||
        !slam::writeAll(output_, content, header.size))
      throw std::runtime_error("the reader is gone");
  }
  void write(Kind kind, const std::string& text) const {
    write({kind, static_cast<std::uint32_t>(text.size()), 0, {}}, text.data());
  }
  void write(std::uint32_t number, const ros::Time& time) const {
    write({Kind::kNumber, 0, number, time}, nullptr);
  }

 private:
  int output_;
};

/// Grows with what is really there.
struct MessageBytes {
  std::vector<std::uint8_t> bytes;
  std::uint8_t* advance(std::uint32_t size) { return bytes.resize(size), bytes.data(); }
};

/// A closed bag, which each child opens in its copy. Its constructor loads a plugin: in a child it
/// would wait forever where a thread that is not in this copy holds the lock for that, as while
/// nodelets are loaded.
rosbag::Bag& closedBag() {
  static auto& bag = *new rosbag::Bag();  // never destroyed: other threads may still read at exit
  return bag;
}

void open(rosbag::Bag& bag, const std::string& path) {
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(
        "it has no index, as if its recording was cut off; `rosbag reindex` may save it");
  } catch (const rosbag::BagFormatException&) {
    throw std::runtime_error("it is not a bag");
  } catch (const rosbag::BagIOException& fault) {
    throw std::runtime_error(std::string("it is not a bag, or its end is missing (") +
                             fault.what() + ")");
  }
}

void writeContents(rosbag::Bag& bag, const PieceWriter& out) {
  rosbag::View all(bag);
  const bool is_empty = all.size() == 0;
  out.write(0, is_empty ? ros::Time() : all.getBeginTime());
  out.write(0, is_empty ? ros::Time() : all.getEndTime());
  if (is_empty) return;
  std::vector<std::string> told;
  for (const auto* connection : all.getConnections()) {
    const auto& name = connection->topic;
    const auto is_same = [&](const std::string& other) { return sameTopic(other, name); };
    if (std::any_of(told.begin(), told.end(), is_same)) continue;  // one of several publishers
    told.push_back(name);
    const auto md5sum = md5sumOfToday(connection->datatype, connection->md5sum);
    for (const auto& text : {name, connection->datatype, md5sum}) out.write(Kind::kText, text);
    out.write(rosbag::View(bag, rosbag::TopicQuery(name)).size(), {});
  }
}

void writeMessages(rosbag::Bag& bag, const std::vector<std::string>& topics,
                   const PieceWriter& out) {
  std::map<std::string, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < topics.size(); ++i) numbers[topics[i]] = i;
  MessageBytes buffer;
  for (const auto& message : rosbag::View(bag, rosbag::TopicQuery(topics))) {
    buffer.bytes.clear();
    message.write(buffer);
    bringUpToDate(message.getMD5Sum(), buffer.bytes);
    out.write({Kind::kMessage, static_cast<std::uint32_t>(buffer.bytes.size()),
               numbers.at(message.getTopic()), message.getTime()},
              buffer.bytes.data());
  }
}

/// What the library throws is of many kinds, and says little to who has the bag.
template <class Work>
slam::ChildProcess::Work onBag(const std::string& path, Work work) {
  return [path, work, &bag = closedBag()](int output) {
    console_bridge::noOutputHandler();  // a thread that is not in this copy may hold its lock
    const PieceWriter out(output);
    const auto fail = [&](const std::string& fault) { out.write(Kind::kFault, fault); };
    try {
      open(bag, path);
      work(bag, out);
      out.write(Kind::kEnd, "");
    } catch (const std::bad_alloc&) {
      fail("it is damaged (it asks for more memory than such a bag can need)");
    } catch (const std::length_error&) {
      fail("it is damaged (it asks for more memory than such a bag can need)");
    } catch (const ros::Exception& fault) {
      fail(std::string("it is damaged (") + fault.what() + ")");
    } catch (const std::exception& fault) {
      fail(fault.what());
    }
    return 0;
  };
}

slam::ChildLimits limitsFor(const std::string& path) {
  constexpr std::uint64_t kMemory = 1u << 30, kMemoryPerByte = 8, kBytesPerSecond = 1u << 20;
  const auto size = std::filesystem::file_size(path);
  return {kMemory + kMemoryPerByte * size, 20 + size / kBytesPerSecond};
}

/// The parent's side.
class BagProcess {
 public:
  template <class Work>
  BagProcess(const std::string& path, Work work) : child_(limitsFor(path), onBag(path, work)) {}

  /// The next piece. @throw std::runtime_error with what is wrong with the bag
  PieceHeader next() {
    PieceHeader header;
    if (!slam::readAll(child_.output(), &header, sizeof(header))) failWithCrash();
    content_.clear();
    while (content_.size() < header.size) {
      const auto before = content_.size();
      content_.resize(std::min<std::size_t>(header.size, before + kBlock));
      if (!slam::readAll(child_.output(), content_.data() + before, content_.size() - before))
        failWithCrash();
    }
    if (header.kind == Kind::kFault) throw std::runtime_error(text());
    return header;
  }
  std::vector<std::uint8_t>& content() { return content_; }
  std::string text() const { return {content_.begin(), content_.end()}; }

 private:
  static constexpr std::size_t kBlock = 16u << 20;  // [B] that room is made for at once

  [[noreturn]] void failWithCrash() {
    const auto end = child_.wait();
    throw std::runtime_error("it is damaged (reading it ends with " +
                             (end.crash.empty() ? std::string("a fault") : end.crash) + ")");
  }

  slam::ChildProcess child_;
  std::vector<std::uint8_t> content_;
};

}  // namespace

BagContents contentsOfBag(const std::string& path) {
  BagProcess process(path, writeContents);
  BagContents contents;
  contents.begin = process.next().time;
  contents.end = process.next().time;
  while (process.next().kind != Kind::kEnd) {
    BagTopic topic;
    topic.name = process.text();
    process.next();
    topic.type = process.text();
    process.next();
    topic.md5sum = process.text();
    topic.messages = process.next().topic;
    contents.topics.push_back(topic);
  }
  std::sort(contents.topics.begin(), contents.topics.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return contents;
}

void readBag(const std::string& path, const std::vector<std::string>& topics,
             const std::function<bool(const BagMessage&)>& take) {
  BagProcess process(
      path, [&](rosbag::Bag& bag, const PieceWriter& out) { writeMessages(bag, topics, out); });
  for (auto header = process.next(); header.kind == Kind::kMessage; header = process.next())
    if (!take({topics.at(header.topic), header.time, process.content()})) return;
}

}  // namespace slam_ros
