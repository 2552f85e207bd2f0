// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"

namespace slam::mono_ekf {

/// Whether the robot is where the filter has it: it is lost when for some time an image that has
/// enough to see shows hardly any feature where it is predicted.
class TrackingWatch {
 public:
  TrackingWatch() = default;
  /// @param patience how long that may last [s]
  explicit TrackingWatch(double patience) : patience_(patience) {}

  /// An image: how many features were searched, and on how many of them it agrees.
  /// @param has_texture it shows corners; else it contradicts nothing
  /// @return whether it makes the robot lost
  bool judge(Stamp stamp, std::size_t searched, std::size_t agreed, bool has_texture);
  /// The pose is known again.
  void settle() { lost_since_.reset(), contradicted_since_.reset(); }

  std::optional<Stamp> lostSince() const { return lost_since_; }
  bool isContradicted() const { return contradicted_since_.has_value(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(contradicted_since_, lost_since_);
  }

 private:
  double patience_ = 0.0;
  std::optional<Stamp> contradicted_since_, lost_since_;
};

}  // namespace slam::mono_ekf
