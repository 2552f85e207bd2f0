// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/earlier_messages.hpp"

#include <slam_msgs/LandmarkMap.h>
#include <slam_msgs/LandmarkObservationArray.h>

#include <array>
#include <cstring>

namespace slam_ros {
namespace {

/// A message that ends with an array whose items have got longer: what is new is zero, or an array
/// that is empty.
struct EarlierMessage {
  const char* type;
  const char* md5sum;
  const char* md5sum_today;
  std::size_t after_header;  // [B] between header and array
  std::size_t item;          // [B] of an item
  std::size_t added;         // [B] at the end of each item
};

template <class Message>
EarlierMessage earlier(const char* md5sum, std::size_t after_header, std::size_t item,
                       std::size_t added) {
  return {ros::message_traits::DataType<Message>::value(),
          md5sum,
          ros::message_traits::MD5Sum<Message>::value(),
          after_header,
          item,
          added};
}

constexpr std::size_t kPoint = 8 + 2 * 8 + 4 * 8;  // id, two coordinates, covariance
constexpr std::size_t kSeen = 1 + 2 * 8;           // kind, begin, end
constexpr std::size_t kMapped = 1 + 3 * 8;         // kind, direction, begin, end
constexpr std::size_t kDescriptor = 2 * 4;         // the lengths of descriptor and sigmas

const std::array<EarlierMessage, 4>& earlierMessages() {
  constexpr std::size_t kBefore = 8 + 3 * 8;  // sequence and sensor pose
  using Observations = slam_msgs::LandmarkObservationArray;
  using Map = slam_msgs::LandmarkMap;
  static const std::array<EarlierMessage, 4> messages = {
      earlier<Observations>("4d86d73cdfcf3dec4ab59a5ebc938d7b", kBefore, kPoint,
                            kSeen + kDescriptor),
      earlier<Observations>("db61b129d3736d6ddb520d68f8481a23", kBefore, kPoint + kSeen,
                            kDescriptor),
      earlier<Map>("e0a367408d6ec1d3545dd6bf126df413", 0, kPoint, kMapped + kDescriptor),
      earlier<Map>("5656c7fc0763bd4a9c4a63d2e6ce62a4", 0, kPoint + kMapped, kDescriptor)};
  return messages;
}

std::size_t numberAt(const std::vector<std::uint8_t>& bytes, std::size_t offset) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof(number));
  return number;
}

/// Where the array's items begin; 0 where the bytes are too few.
std::size_t itemsOf(const EarlierMessage& message, const std::vector<std::uint8_t>& bytes) {
  constexpr std::size_t kFrameLength = 12, kNumber = 4;  // after sequence and stamp of the header
  if (bytes.size() < kFrameLength + kNumber) return 0;
  const auto items =
      kFrameLength + kNumber + numberAt(bytes, kFrameLength) + message.after_header + kNumber;
  if (bytes.size() < items) return 0;
  const auto count = numberAt(bytes, items - kNumber);
  return bytes.size() == items + count * message.item ? items : 0;
}

}  // namespace

std::string md5sumOfToday(const std::string& type, const std::string& md5sum) {
  for (const auto& message : earlierMessages())
    if (type == message.type && md5sum == message.md5sum) return message.md5sum_today;
  return md5sum;
}

void bringUpToDate(const std::string& md5sum, std::vector<std::uint8_t>& bytes) {
  for (const auto& message : earlierMessages()) {
    if (md5sum != message.md5sum) continue;
    const auto items = itemsOf(message, bytes);
    if (items == 0) return;
    std::vector<std::uint8_t> longer(bytes.begin(),
                                     bytes.begin() + static_cast<std::ptrdiff_t>(items));
    for (auto at = items; at < bytes.size(); at += message.item) {
      const auto* item = bytes.data() + at;
      longer.insert(longer.end(), item, item + message.item);
      longer.resize(longer.size() + message.added, 0);
    }
    bytes = std::move(longer);
    return;
  }
}

}  // namespace slam_ros
