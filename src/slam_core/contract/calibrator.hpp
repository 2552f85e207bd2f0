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
  /// What the drive has told so far; nothing where nothing is calibrated.
  virtual std::optional<CalibrationEstimate> calibration() const = 0;
  /// What it estimates, from which priors.
  virtual const CalibrationConfig& calibrationConfig() const = 0;
};

}  // namespace slam
