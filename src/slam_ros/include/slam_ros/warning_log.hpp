// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slam_ros {

/// Keeps the warnings of a run readable: the first warning of each kind is printed, and at the end
/// their number. Warnings that differ only in their numbers (ids, stamps) are of one kind. At most
/// kMostSaid kinds are printed; urgent ones always are.
class WarningLog {
 public:
  static constexpr std::size_t kMostSaid = 10;

  /// @return what is to be printed of it now; may be empty
  std::string add(const std::string& sentence, bool is_urgent = false);

  /// A line for each kind whose warnings were not all printed: the urgent ones first, then in the
  /// order in which they came.
  std::vector<std::string> summary() const;

  /// The sentence with '#' in the place of each number, and of each list of numbers.
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
  std::uint64_t beyond_ = 0;  ///< warnings of more kinds than can be distinguished
  bool has_told_of_more_ = false;
};

}  // namespace slam_ros
