// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>
#include <string>

#include "slam_core/common/settings.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/tuning/noise_tuner.hpp"

namespace slam::tuning {

/// What a back-end has calibrated, as values of the robot file. Parameters that the drive does not
/// tell keep their values, and say so.
/// @param settings of the run, for the values before
/// @throw ConfigError as Settings::read()
std::vector<TunedParameter> calibratedParameters(const Calibrator& calibrator, Settings settings);

/// The robot file with these values (withTunedValues()), and in a remark above them what the drive
/// reported of each parameter; nothing where the back-end calibrates nothing.
/// @param robot_file its text
/// @throw ConfigError where its layout does not allow that
std::optional<std::string> calibratedRobot(const Calibrator& calibrator, const Settings& settings,
                                           const std::string& robot_file);

/// Writes calibratedRobot() into a folder as robot.yaml; does nothing where nothing is calibrated.
/// @param robotFile gives the robot file's text; called only where something is calibrated
/// @return empty, or why it could not be written: the run itself is not spoilt by that
std::string saveCalibration(const Capabilities& backend, const Settings& settings,
                            const std::function<std::string()>& robotFile,
                            const std::string& folder);

}  // namespace slam::tuning
