// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/silence_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {
namespace {

double seconds(SilenceWatch::Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

std::string SilenceWatch::heard(const std::string& input, Clock::time_point now) {
  const auto [entry, is_new] = inputs_.insert({input, {now}});
  const auto before = entry->second;
  entry->second = {now};
  if (is_new || !before.isSilent(now)) return "";
  return fmt::format("{} comes again after {:.1f} s without any", input,
                     seconds(now - before.last));
}

std::string SilenceWatch::sentence(Clock::time_point now) const {
  std::vector<std::string> silent;
  Clock::time_point since = now;
  for (const auto& [name, input] : inputs_) {
    if (!input.isSilent(now)) continue;
    silent.push_back(name);
    since = std::min(since, input.last);
  }
  if (silent.empty()) return "";
  return fmt::format(
      "stale: nothing has come on {} for {:.0f} s; is the link, or what sends it, down?",
      slam::join(silent, " and "), seconds(now - since));
}

std::string SilenceWatch::news(Clock::time_point now) {
  bool any = false;
  for (auto& [name, input] : inputs_) {
    if (!input.isSilent(now) || input.is_told) continue;
    any = input.is_told = true;
  }
  return any ? sentence(now) : "";
}

}  // namespace slam_ros
