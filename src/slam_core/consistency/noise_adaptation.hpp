// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "slam_core/consistency/consistency_monitor.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Enlarges noise that the innovations show to be larger than reported. So the back-end's
/// covariance covers errors that the robot file does not contain: a wheel whose radius is wrong, or
/// a detector whose ranges scatter more than it reports (adaptive filtering: Mehra 1970). It uses
/// the findings of the ConsistencyMonitor:
/// - A sigma that looks too small is multiplied by the factor found.
/// - Biased innovations show an error that is not noise. If it is one of the path, the motion's
///   sigma grows; if it is one of all ranges or bearings, that of the sensor.
/// - A sigma that was enlarged and now looks too large is reduced, but never below the reported
///   one.
///
/// If the gate rejects most observations, nothing is learnt: the robot may have been carried away,
/// and is found by other means.
class NoiseAdaptation {
 public:
  using Source = ConsistencyMonitor::Source;

  /// To be called for each step, after the monitor has got its innovations.
  /// @param statistics of the step. If they do not contain the Jacobian H of the innovations by the
  /// pose, as those of a particle filter, the sources cannot be separated, and only the odometry's
  /// noise is enlarged
  /// @return whether a scale has changed; then earlier results of the monitor are for another scale
  bool learn(const ConsistencyMonitor& monitor, const UpdateStatistics& statistics);
  /// The factor on a source's reported sigma, at least 1.
  double scale(Source source) const { return scales_[source]; }

  /// The input with enlarged noise; unchanged if the result would be a fault (faultOf()).
  Motion scaled(const Motion& motion) const;
  LandmarkObservationArray scaled(LandmarkObservationArray array) const;
  bool isNeutral() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(scales_);
  }

 private:
  bool multiply(Source source, double factor);

  std::array<double, ConsistencyMonitor::kSources> scales_ = {1.0, 1.0, 1.0};
};

}  // namespace slam
