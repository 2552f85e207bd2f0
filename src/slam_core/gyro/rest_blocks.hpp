// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/gyro/gyro_noise.hpp"

namespace slam::gyro {

/// A gyro's mean rate over a time in which the robot rested.
struct RestRate {
  double seconds = 0.0;
  double angle = 0.0;  ///< [rad]
  double rate() const { return angle / seconds; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(seconds, angle);
  }
};

/// Cuts what a gyro measures while the wheels stand into blocks of a quarter of a second. A block
/// counts when the next one is full and measures the same: the last one before the robot moves is
/// left out, and so are those in which somebody turns it.
class RestBlocks {
 public:
  /// A turn while the wheels stand. The noise learns from blocks that count.
  /// @return the block that counts now, where one does
  std::optional<RestRate> add(double angle, double seconds, GyroNoise& noise);
  /// The rest is over, or was not measured.
  void clear() { *this = {}; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_, current_);
  }

 private:
  std::optional<RestRate> last_;  ///< full
  RestRate current_;
};

}  // namespace slam::gyro
