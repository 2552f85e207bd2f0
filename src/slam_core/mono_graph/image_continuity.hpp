// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/mono_graph/features.hpp"
#include "slam_core/mono_graph/odometry_anchor.hpp"

namespace slam::mono_graph {

/// Judges whether the images go on showing the same scene, without the map: a robot that was
/// carried, or whose camera was turned, sees another one. The features of an image are searched for
/// in those that follow, where odometry and any depth predict them. An image that shows some of
/// them takes its place. While none does, the earlier image stays, until the robot has moved too
/// far to see the same. If it has moved far enough before that, the robot is lost.
///
/// An object that passes by hides the scene, too, but does not stand still as a scene does. So the
/// earlier image has to be one that shows what another one showed, and a later image counts only if
/// it shows what the image just before it showed. It counts by the robot's motion: while the robot
/// stands, an object may stand in front of it.
class ImageContinuity {
 public:
  /// To be called with each motion before the image at its end.
  void move(const Motion& motion);
  /// To be called with each image that has features.
  void judge(const Features& features, Stamp stamp);
  /// To be called when the pose is known again: the next image is compared with none.
  void settle();

  bool isLost() const { return lost_since_.has_value(); }
  /// The first image that showed nothing of the scene before it, of those that led to the loss,
  /// which lasts until settle().
  const std::optional<Stamp>& lostSince() const { return lost_since_; }
  /// Whether the last image may be used for the map: not if it shows nothing of the scene.
  bool admits() const { return !broken_since_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(earlier_, is_scene_, last_, broken_since_, broken_, lost_since_);
  }

 private:
  /// An image that others are compared with.
  struct Image {
    Features features;
    OdometryAnchor odometry;  ///< since then

    template <class Archive>
    void persist(Archive& archive) {
      archive(features, odometry);
    }
  };

  /// Whether an image shows the same scene as another one.
  enum class Same { kYes, kNo, kUnknown };
  static Same compared(const Image& earlier, const Features& features);
  void begin(const Features& features, bool is_scene);
  void contradict(const Features& features, Stamp stamp);

  std::optional<Image> earlier_;
  bool is_scene_ = false;              ///< the earlier image shows what another one showed
  std::optional<Image> last_;          ///< the image before this one, if it is another one
  std::optional<Stamp> broken_since_;  ///< the first image that does not show the earlier one
  double broken_ = 0.0;                ///< the weight of those images
  std::optional<Stamp> lost_since_;
};

}  // namespace slam::mono_graph
