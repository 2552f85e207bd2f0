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

std::vector<std::string> SilenceWatch::missing(Clock::time_point now) const {
  const bool are_all = std::all_of(inputs_.begin(), inputs_.end(),
                                   [&](const auto& entry) { return entry.second.isSilent(now); });
  std::vector<std::string> names;
  for (const auto& [name, input] : inputs_)
    if (are_all ||
        input.isSilent(now, with_pauses_.count(name) > 0 ? kPatienceWithPauses : kPatience))
      names.push_back(name);
  return names;
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
  const auto names = missing(now);
  if (names.empty()) return "";
  Clock::time_point since = now;
  for (const auto& name : names) since = std::min(since, inputs_.at(name).last);
  const auto* const others = names.size() < inputs_.size() ? ", while other inputs go on" : "";
  return fmt::format(
      "stale: nothing has come on {} for {:.0f} s{}; is the link, or what sends it, down?",
      slam::join(names, " and "), seconds(now - since), others);
}

std::string SilenceWatch::news(Clock::time_point now) {
  bool is_new = false;
  for (const auto& name : missing(now)) is_new |= !std::exchange(inputs_.at(name).is_told, true);
  return is_new ? sentence(now) : "";
}

}  // namespace slam_ros
