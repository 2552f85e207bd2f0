// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slam_ros {

/// The warnings of a run, so that they can be read: of each kind the first one is said, and at the
/// end how many there were. Warnings that differ in their numbers only (ids, stamps) are of one
/// kind. So many kinds are said (kMostSaid); those that are urgent always are.
class WarningLog {
 public:
  static constexpr std::size_t kMostSaid = 10;

  /// @return what is to be said of it now; empty: nothing
  std::string add(const std::string& sentence, bool is_urgent = false);

  /// A line for each kind that was not said each time it came, the urgent ones first and then in
  /// the order in which they came.
  std::vector<std::string> summary() const;

  /// The sentence with '#' for its numbers, and one '#' for a list of them.
  static std::string kindOf(const std::string& sentence);

 private:
  struct Kind {
    std::string first;
    std::size_t order = 0;
    std::uint64_t count = 0;
    bool is_said = false, is_urgent = false;
  };

  std::map<std::string, Kind> kinds_;
  std::size_t said_ = 0;      ///< kinds that are not urgent
  std::uint64_t beyond_ = 0;  ///< warnings of more kinds than can be told apart
  bool has_told_of_more_ = false;
};

}  // namespace slam_ros
