// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/progress.hpp"

#include <algorithm>
#include <iomanip>

namespace slam {
namespace {

constexpr int kBarWidth = 40;
constexpr std::chrono::seconds kLineInterval{2};

}  // namespace

Progress::Progress(std::ostream& out, bool is_terminal) : out_(out), is_terminal_(is_terminal) {}

void Progress::begin(const std::string& phase, std::size_t total) {
  end();
  phase_ = phase;
  total_ = std::max<std::size_t>(total, 1);
  last_line_ = std::chrono::steady_clock::now();
  if (is_terminal_) draw(0);
}

void Progress::update(std::size_t done) {
  const int percent = static_cast<int>(100 * std::min(done, total_) / total_);
  if (phase_.empty() || percent == shown_percent_) return;
  if (is_terminal_) {
    draw(percent);
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - last_line_ < kLineInterval) return;
  last_line_ = now;
  shown_percent_ = percent;
  out_ << phase_ << ": " << percent << " %" << std::endl;
}

void Progress::clear() {
  if (is_terminal_ && !phase_.empty())
    out_ << '\r' << std::string(phase_.size() + kBarWidth + 10, ' ') << '\r' << std::flush;
  shown_percent_ = -1;
}

void Progress::end() {
  clear();
  phase_.clear();
}

void Progress::draw(int percent) {
  shown_percent_ = percent;
  const int filled = kBarWidth * percent / 100;
  out_ << '\r' << phase_ << " [" << std::string(static_cast<std::size_t>(filled), '#')
       << std::string(static_cast<std::size_t>(kBarWidth - filled), ' ') << "] " << std::setw(3)
       << percent << " %" << std::flush;
}

}  // namespace slam
