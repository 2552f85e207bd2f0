// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <optional>

#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// Tells whether a source reports motion by way: each time that the robot has moved or turned by a
/// fixed amount, as a logger does that leaves out what was standing. Its steps are long and all
/// about the same. Such a source is silent while the robot stands.
///
/// A robot that drives steadily and reports its motion every few seconds looks the same. Steps of
/// less than 0.2 m are taken to be by time.
class UsualStep {
 public:
  void note(const Pose2& step) {
    const double size = sizeOf(step);
    if (known_ < kMeant) ++known_;
    deviation_ += (std::abs(size - mean_) - deviation_) / known_;
    mean_ += (size - mean_) / known_;
  }
  /// @return how many usual steps of a source that reports by way this is; nothing if the source
  /// reports by time, or lets no such step pass: less than half of one, or more than three. After a
  /// pause it may be two, since the first message may be left out (StampJump), and either of them
  /// longer than the mean.
  std::optional<double> countOf(const Pose2& step) const {
    constexpr double kLeastStep = 0.2;           // [m]
    constexpr double kMostDeviation = 0.5;       // of the mean
    constexpr double kLeast = 0.5, kMost = 3.0;  // usual steps
    const bool is_by_way =
        known_ == kMeant && mean_ >= kLeastStep && deviation_ <= kMostDeviation * mean_;
    if (!is_by_way) return std::nullopt;
    const double count = sizeOf(step) / mean_;
    return count >= kLeast && count <= kMost ? std::make_optional(count) : std::nullopt;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(mean_, deviation_, known_);
  }

 private:
  static constexpr int kMeant = 20;  ///< steps
  static double sizeOf(const Pose2& step) {
    constexpr double kMetresPerRadian = 0.5;
    return step.position().norm() + kMetresPerRadian * std::abs(step.theta());
  }

  double mean_ = 0.0, deviation_ = 0.0;  ///< [m]
  int known_ = 0;                        ///< steps, or kMeant where there were more
};

}  // namespace slam
