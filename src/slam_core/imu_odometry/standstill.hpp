// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/models/motion.hpp"

namespace slam::imu_odometry {

/// Whether the wheels stand, and have done so for long enough that the robot does not rock any
/// more.
class Standstill {
 public:
  /// The wheels' next motion.
  void add(const Motion& wheels);
  bool isResting() const { return !has_moved_ || rested_ >= kSettling; }
  void reset() { *this = {}; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(has_moved_, rested_);
  }

 private:
  static constexpr Duration kSettling = std::chrono::milliseconds(500);

  bool has_moved_ = false;
  Duration rested_{};
};

}  // namespace slam::imu_odometry
