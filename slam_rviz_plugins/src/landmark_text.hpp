// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <slam_msgs/Landmark.h>
#include <slam_msgs/LandmarkLabels.h>

#include <QString>
#include <QStringList>

namespace slam_rviz_plugins {

/// What a message says of a landmark, for people, a line each: its id, its position with standard
/// deviations [m] and, of a wall, its direction [rad] and the length that was seen [m]; then what
/// it looks like, where that is known.
/// @param label stands behind the id; empty: it has none
QStringList describe(const slam_msgs::Landmark& landmark, const QString& label = "");

/// The label of a landmark; empty where it has none.
QString labelOf(const slam_msgs::Landmark& landmark, const slam_msgs::LandmarkLabels& labels);

}  // namespace slam_rviz_plugins
