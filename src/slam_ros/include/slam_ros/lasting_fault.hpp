// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam_ros {

/// The last fault of things of one kind, until one without a fault comes.
class LastingFault {
 public:
  /// @param fault of the next thing, empty: none
  void note(const std::string& fault) {
    has_ended_ = has_ended_ || fault.empty();
    fault_ = has_ended_ ? "" : fault;
  }
  const std::string& text() const { return fault_; }

 private:
  bool has_ended_ = false;
  std::string fault_;
};

}  // namespace slam_ros
