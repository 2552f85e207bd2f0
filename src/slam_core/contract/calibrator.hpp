// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/calibration.hpp"

namespace slam {

/// The capability of a back-end that estimates parameters of wheels and landmark sensor as well as
/// pose and map (section `calibration`).
///
/// Who calls: the Estimator and the drivers, between two steps.
class Calibrator {
 public:
  virtual ~Calibrator() = default;
  /// @return the parameters as estimated from the drive so far; nothing if nothing is calibrated
  virtual std::optional<CalibrationEstimate> calibration() const = 0;
  /// @return the names of the estimated parameters, and their priors
  virtual const CalibrationConfig& calibrationConfig() const = 0;
  /// @return the observations corrected by these parameters; to be called only if something is
  /// calibrated
  virtual LandmarkObservationArray corrected(const LandmarkObservationArray& array) const = 0;
};

}  // namespace slam
