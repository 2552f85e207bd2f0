// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/silence_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {
namespace {

double seconds(SilenceWatch::Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

bool SilenceWatch::isSilent(Clock::time_point now) const {
  return !inputs_.empty() && std::all_of(inputs_.begin(), inputs_.end(), [&](const auto& entry) {
    return entry.second.isSilent(now);
  });
}

std::string SilenceWatch::heard(const std::string& input, Clock::time_point now) {
  const auto [entry, is_new] = inputs_.insert({input, {now}});
  const auto before = entry->second;
  entry->second = {now};
  if (is_new || !before.is_told) return "";
  return fmt::format("{} comes again after {:.1f} s without any", input,
                     seconds(now - before.last));
}

std::string SilenceWatch::sentence(Clock::time_point now) const {
  if (!isSilent(now)) return "";
  std::vector<std::string> names;
  Clock::time_point since = now;
  for (const auto& [name, input] : inputs_) {
    names.push_back(name);
    since = std::min(since, input.last);
  }
  return fmt::format(
      "stale: nothing has come on {} for {:.0f} s; is the link, or what sends it, down?",
      slam::join(names, " and "), seconds(now - since));
}

std::string SilenceWatch::news(Clock::time_point now) {
  if (!isSilent(now)) return "";
  bool is_new = false;
  for (auto& [name, input] : inputs_) is_new |= !std::exchange(input.is_told, true);
  return is_new ? sentence(now) : "";
}

}  // namespace slam_ros
