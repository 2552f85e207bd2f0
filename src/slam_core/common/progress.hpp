// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace slam {

/// Shows how far a long piece of work is: a bar on a terminal; elsewhere a plain line every few
/// seconds, so that a log stays short and quick work leaves no line at all.
class Progress {
 public:
  Progress(std::ostream& out, bool is_terminal);

  /// Begins a phase of `total` steps and ends the one before.
  void begin(const std::string& phase, std::size_t total);

  /// `done` of the phase's steps are finished.
  void update(std::size_t done);

  /// Takes the bar away, so that a line can be printed; the next update() draws it again.
  void clear();

  /// Ends the phase; what is printed next starts on a line of its own.
  void end();

 private:
  void draw(int percent);

  std::ostream& out_;
  bool is_terminal_;
  std::string phase_;
  std::size_t total_ = 0;
  int shown_percent_ = -1;
  std::chrono::steady_clock::time_point last_line_;
};

}  // namespace slam
