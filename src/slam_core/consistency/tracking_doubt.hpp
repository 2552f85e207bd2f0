// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

#include "slam_core/common/time.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam {

/// What an image shows of the features that the map has in its view.
struct ViewOfMap {
  /// Features that the image should show. Those that were mapped since the doubt began
  /// (TrackingDoubt::doubtedSince) do not count: they agree with a wrong pose.
  std::size_t expected = 0;
  std::size_t found = 0;  ///< of these, where they are expected
  /// Probability that a feature is where it was searched, which is not everywhere where the pose is
  /// so uncertain that it may be far off.
  double in_reach = 1.0;
};

/// Decides whether a robot is lost, by a sequential test on the share of the expected features that
/// each image shows: the log-likelihood ratio of "lost" to "right" is summed over the images and
/// never falls below zero (CUSUM, Page 1954), as in scan_matching::ScanDoubt. The share at a right
/// pose is learnt, since people hide features in every building, and repeated patterns hide them in
/// some. It varies from image to image, so that the counts are beta-binomial (Skellam 1948). A lost
/// robot finds some features by chance.
///
/// With a threshold h there are at least e^h independent images between two false alarms in the
/// mean (Lorden 1971), if the learnt distribution holds. The errors of images that follow one
/// another closely are correlated: the weight of an image grows with the distance, the turn and the
/// time since the last one, up to 1.
class TrackingDoubt {
 public:
  /// @param false_alarm_hours mean time between two false alarms, of a robot under way [h]
  explicit TrackingDoubt(double false_alarm_hours = 100.0);

  /// To be called for each image that has features; dark and blurred ones say nothing.
  /// @param pose of the robot after it, map frame
  void judge(const ViewOfMap& view, const Pose2& pose, Stamp stamp);
  /// To be called when the pose is known again.
  void settle();

  bool isLost() const { return lost_since_.has_value(); }
  /// The image with which the doubt began that led to the loss, which lasts until settle().
  const std::optional<Stamp>& lostSince() const { return lost_since_; }
  /// The image with which the doubt began; nothing where there is none.
  std::optional<Stamp> doubtedSince() const;
  /// Whether the last image may be used for the map: not if the robot is lost, or if this image,
  /// alone or with those before it, is evidence for that.
  bool admits() const;
  /// Whether the last image is evidence for a lost robot.
  bool isContradicted() const { return evidence_ > 0.0; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(mean_, variance_, sum_, evidence_, began_, most_expected_, lost_since_, pose_, stamp_);
  }

 private:
  double weightOf(const Pose2& pose, Stamp stamp) const;
  double evidenceOf(const ViewOfMap& view) const;
  void learn(double share, double weight);

  double threshold_;
  double mean_, variance_;  ///< of the share that a robot sees that is right
  double sum_ = 0.0, evidence_ = 0.0;
  Stamp began_;                 ///< the sum was last at zero before this image
  double most_expected_ = 0.0;  ///< features in one image since then
  std::optional<Stamp> lost_since_;
  std::optional<Pose2> pose_;  ///< at the last image
  Stamp stamp_;
};

}  // namespace slam
