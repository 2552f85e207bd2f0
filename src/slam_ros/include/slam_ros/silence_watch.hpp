// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <map>
#include <string>

namespace slam_ros {

/// Notices that inputs which had come come no more, as when a link to another machine is cut: by
/// the wall, since the stamps' time stands still with them. An input that has never come is not
/// missed here.
class SilenceWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kPatience{3};

  /// @return empty, or that the input comes again and how long it was silent
  std::string heard(const std::string& input, Clock::time_point now);

  /// Which inputs are silent and for how long, or empty.
  std::string sentence(Clock::time_point now) const;

  /// As sentence(), when one of them has become silent since the last call.
  std::string news(Clock::time_point now);

 private:
  struct Input {
    Clock::time_point last;
    bool is_told = false;  ///< of its silence, by news()

    bool isSilent(Clock::time_point now) const { return now - last > kPatience; }
  };

  std::map<std::string, Input> inputs_;
};

}  // namespace slam_ros
