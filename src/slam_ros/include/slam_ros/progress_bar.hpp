// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

namespace slam_ros {

/// Shows on stderr how far a run is: a bar on a terminal, a line every ten percent elsewhere.
class ProgressBar {
 public:
  ProgressBar(std::string title, std::size_t total);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(std::size_t done);
  /// Takes the bar away, so that a line can be printed; the next update() draws it again.
  void clear();

 private:
  std::string title_;
  std::size_t total_, next_ = 0;
  bool is_terminal_, is_drawn_ = false;
};

}  // namespace slam_ros
