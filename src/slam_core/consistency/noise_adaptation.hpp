// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "slam_core/consistency/consistency_monitor.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// Enlarges noise that the innovations show to be larger than reported, so that the back-end's
/// covariance covers what the robot file does not know: a wheel whose radius is wrong, or a
/// detector whose ranges scatter more than it says (adaptive filtering: Mehra 1970). It acts on
/// what the ConsistencyMonitor finds:
/// - A sigma that looks too small is multiplied by the factor found.
/// - Innovations that are biased show an error that is no noise. Where it is one of the way, the
///   motion's sigma grows; where it is one of all ranges or bearings, that of the sensor.
/// - A sigma that was enlarged and looks too large by now is reduced, never below that reported.
///
/// Where the gate rejects most of what is seen, nothing is learnt: the robot may have been carried
/// away, and is found by other means.
class NoiseAdaptation {
 public:
  using Source = ConsistencyMonitor::Source;

  /// To be called for each step, after the monitor has got its innovations.
  /// @param statistics of the step: where they do not say how the pose moves the innovations
  /// (H), as a particle filter's, the sources cannot be separated, and the odometry gets all
  /// @return whether a scale has changed: what the monitor has judged so far was of another one
  bool learn(const ConsistencyMonitor& monitor, const UpdateStatistics& statistics);
  /// The factor on a source's reported sigma, at least 1.
  double scale(Source source) const { return scales_[source]; }

  /// What would be a fault of the input when enlarged (faultOf()) stays as it is.
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
