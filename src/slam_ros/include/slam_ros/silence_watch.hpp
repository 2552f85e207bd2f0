// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace slam_ros {

/// Notices that inputs have stopped, for example since a link to another machine is cut or a sensor
/// has failed. It uses the wall clock, since the time of the stamps stands still with the inputs.
/// An input that pauses alone is given more time if pauses are normal for it, such as observations
/// while nothing is seen.
class SilenceWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kPatience{3};
  static constexpr std::chrono::seconds kPatienceWithPauses{10};

  /// The input may pause while others go on: then kPatienceWithPauses holds.
  void mayPause(const std::string& input) { with_pauses_.insert(input); }

  /// @return a sentence if the input comes again after a silence that news() has reported;
  /// otherwise empty
  std::string heard(const std::string& input, Clock::time_point now);

  /// Which inputs are silent, and for how long; or empty.
  std::string sentence(Clock::time_point now) const;

  /// The same as sentence(), but only once for each silence.
  std::string news(Clock::time_point now);

 private:
  struct Input {
    Clock::time_point last;
    bool is_told = false;  ///< news() has reported its silence

    bool isSilent(Clock::time_point now, std::chrono::seconds patience = kPatience) const {
      return now - last > patience;
    }
  };

  /// The silent inputs: all, or those that have stopped while others go on.
  std::vector<std::string> missing(Clock::time_point now) const;

  std::map<std::string, Input> inputs_;
  std::set<std::string> with_pauses_;
};

}  // namespace slam_ros
