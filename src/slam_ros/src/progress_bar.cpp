// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace slam_ros {
namespace {

constexpr std::size_t kWidth = 40;

}  // namespace

ProgressBar::ProgressBar(std::string title, std::size_t total)
    : title_(std::move(title)),
      total_(std::max<std::size_t>(total, 1)),
      is_terminal_(::isatty(STDERR_FILENO) == 1) {
  next_ = is_terminal_ ? 0 : (total_ + 9) / 10;
}

void ProgressBar::update(std::size_t done) {
  if (done < next_) return;
  const auto percent = 100 * std::min(done, total_) / total_;
  const auto shown = is_terminal_ ? percent + 1 : percent - percent % 10 + 10;
  next_ = (total_ * shown + 99) / 100;
  if (!is_terminal_) {
    fmt::print(stderr, "{}: {} %\n", title_, percent);
    return;
  }
  const auto filled = kWidth * percent / 100;
  fmt::print(stderr, "\r{} [{:#>{}}{:>{}}] {:3} %", title_, "", filled, "", kWidth - filled,
             percent);
  std::fflush(stderr);
  is_drawn_ = true;
}

void ProgressBar::clear() {
  if (is_drawn_) fmt::print(stderr, "\r\033[K");
  is_drawn_ = false;
}

}  // namespace slam_ros
