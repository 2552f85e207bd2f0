// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <map>
#include <string>

namespace slam_ros {

/// Notices that inputs which had come come no more, as when a link to another machine is cut: by
/// the wall, since the stamps' time stands still with them. One input alone may well pause, as
/// observations do where there is nothing to see: silence is that of all which have ever come.
class SilenceWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kPatience{3};

  /// @return empty, or that the input comes again after a silence that news() has told
  std::string heard(const std::string& input, Clock::time_point now);

  /// What is silent and for how long, or empty.
  std::string sentence(Clock::time_point now) const;

  /// As sentence(), once for each silence.
  std::string news(Clock::time_point now);

 private:
  struct Input {
    Clock::time_point last;
    bool is_told = false;  ///< of its silence, by news()

    bool isSilent(Clock::time_point now) const { return now - last > kPatience; }
  };

  bool isSilent(Clock::time_point now) const;

  std::map<std::string, Input> inputs_;
};

}  // namespace slam_ros
