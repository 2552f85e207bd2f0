// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <slam_msgs/Landmark.h>

#include <QStringList>

namespace slam_rviz_plugins {

/// What a message says of a landmark, for people, a line each: its id, its position with standard
/// deviations [m] and, of a wall, its direction [rad] and the length that was seen [m]; then what
/// it looks like, where that is known.
QStringList describe(const slam_msgs::Landmark& landmark);

}  // namespace slam_rviz_plugins
