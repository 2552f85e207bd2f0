// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/mono_graph/features.hpp"
#include "slam_core/mono_graph/odometry_anchor.hpp"

namespace slam::mono_graph {

/// Judges whether the robot stands while odometry says so: wheels that hang in the air or that have
/// no encoder do not turn, whatever the robot does. The first image of a standstill is compared
/// with those that follow. The robot is lost if several of them in a row show its features
/// elsewhere. A person who walks past hides features and does not move them. An image from before
/// the robot has come to rest is not like the next ones, and gives way to them.
class StandstillWatch {
 public:
  /// To be called with each motion before the image at its end.
  void move(const Motion& motion);
  /// To be called with each image that has features and that the map cannot judge.
  void judge(const Features& features, Stamp stamp);
  /// To be called when the pose is known again.
  void settle() { *this = {}; }

  bool isLost() const { return lost_since_.has_value(); }
  /// The first image that showed the features elsewhere, of those that led to the loss, which lasts
  /// until settle().
  const std::optional<Stamp>& lostSince() const { return lost_since_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(first_, odometry_, unconfirmed_, moved_, moved_since_, lost_since_);
  }

 private:
  void begin(const Features& features);

  std::optional<Features> first_;  ///< those of the first image
  OdometryAnchor odometry_;        ///< since then
  int unconfirmed_ = 0;            ///< first images that may still give way to the next one
  int moved_ = 0;                  ///< images in a row that show the features elsewhere
  Stamp moved_since_;              ///< the first one of these
  std::optional<Stamp> lost_since_;
};

}  // namespace slam::mono_graph
