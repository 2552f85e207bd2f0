// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/common/settings.hpp"
#include "slam_core/consistency/consistency_monitor.hpp"
#include "slam_core/laser/laser_config.hpp"
#include "slam_core/models/landmark_sensor.hpp"
#include "slam_core/product/event_watch.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

/// Calls visit(Config()) for each section of product and robot files that does not belong to a
/// single component; slam::KnownSections has the others.
template <class Visit>
void visitSharedSections(const Visit& visit) {
  visit(slam::ProductConfig());
  visit(slam::FramesConfig());
  visit(slam::LandmarkSensorConfig());
  visit(slam::EventsConfig());
  visit(slam::ConsistencyConfig());
  visit(slam::LaserConfig());
  visit(TopicsConfig());
}

/// Checks names, types and values of a product file's parameters against the descriptions of all
/// components, including those of its libraries. Overrides, "section.key=value", may also be of a
/// robot file's sections. @throw ConfigError listing all faults
void checkProductFile(const std::string& file, const std::vector<std::string>& overrides);

/// The same for a robot file, with the components in force.
void checkRobotFile(const std::string& file);

/// The same for "section.key=value" that a product file is to hold, with the components in force.
void checkProductParameters(const std::vector<std::string>& parameters);

}  // namespace slam_ros
