// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// Writes a run's checkpoints at intervals of stamps, so that time is the data's. One that cannot
/// be written ends no run: the last good one stays where it is.
class Autosave {
 public:
  /// @param interval [s]; 0: no checkpoint is ever due
  explicit Autosave(double interval = 0.0) : interval_(interval) {}

  double interval() const { return interval_; }
  bool isOn() const { return interval_ > 0.0; }
  /// To be asked after each step. The first interval begins with the first stamp; stamps that went
  /// back count like those that went on.
  bool isDue(Stamp now) {
    if (!last_) last_ = now;
    const auto gone = now > *last_ ? now - *last_ : *last_ - now;
    return isOn() && gone >= durationFromSeconds(interval_);
  }
  /// A checkpoint is being made; the next interval begins.
  void begin(Stamp now) { last_ = now; }
  /// @param make returns the checkpoint's bytes, or throws a std::runtime_error
  /// @return a sentence where the checkpoint could not be written, the first time only
  template <class Make>
  std::string save(Stamp now, const std::string& path, const Make& make) {
    begin(now);
    try {
      writeFileAtomically(path, make());
      has_failed_ = false;
    } catch (const std::runtime_error& error) {
      if (std::exchange(has_failed_, true)) return "";
      return std::string("no checkpoint could be written, the last one stays: ") + error.what();
    }
    return "";
  }

 private:
  double interval_;
  std::optional<Stamp> last_;
  bool has_failed_ = false;  ///< to write the last one
};

}  // namespace slam
