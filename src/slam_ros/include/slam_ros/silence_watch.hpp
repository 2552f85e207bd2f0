// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace slam_ros {

/// Notices that inputs which had come come no more, as when a link to another machine is cut or a
/// sensor has died: by the wall, since the stamps' time stands still with them. An input that
/// pauses alone is given more time where it may well do so, as observations where there is nothing
/// to see.
class SilenceWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kPatience{3};
  static constexpr std::chrono::seconds kPatienceWithPauses{10};

  /// The input may pause while others go on: then kPatienceWithPauses holds.
  void mayPause(const std::string& input) { with_pauses_.insert(input); }

  /// @return empty, or that the input comes again after a silence that news() has reported
  std::string heard(const std::string& input, Clock::time_point now);

  /// What is silent and for how long, or empty.
  std::string sentence(Clock::time_point now) const;

  /// The same as sentence(), but once for each silence only.
  std::string news(Clock::time_point now);

 private:
  struct Input {
    Clock::time_point last;
    bool is_told = false;  ///< of its silence, by news()

    bool isSilent(Clock::time_point now, std::chrono::seconds patience = kPatience) const {
      return now - last > patience;
    }
  };

  /// The inputs that are missed: all, or those that others go on without.
  std::vector<std::string> missing(Clock::time_point now) const;

  std::map<std::string, Input> inputs_;
  std::set<std::string> with_pauses_;
};

}  // namespace slam_ros
