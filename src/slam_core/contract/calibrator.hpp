// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/calibration.hpp"

namespace slam {

/// The capability of a back-end that estimates parameters of wheels and landmark sensor beside pose
/// and map (section `calibration`).
///
/// Who calls: the Estimator and the drivers, between two steps.
class Calibrator {
 public:
  virtual ~Calibrator() = default;
  /// @return the parameters as estimated from the drive so far; nothing where nothing is calibrated
  virtual std::optional<CalibrationEstimate> calibration() const = 0;
  /// @return the names of what is estimated, and the priors
  virtual const CalibrationConfig& calibrationConfig() const = 0;
  /// @return the observations as they are with these parameters; only where something is calibrated
  virtual LandmarkObservationArray corrected(const LandmarkObservationArray& array) const = 0;
};

}  // namespace slam
