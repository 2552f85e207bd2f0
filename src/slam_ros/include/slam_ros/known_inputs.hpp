// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/product/wiring.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

/// Refuses a mandatory input that no component of the wiring makes and no topic can bring, since no
/// binding is registered for its kind: such a component would wait for ever. What is latched comes
/// with the data of the same port.
/// @throw slam::ConfigError naming the component, the input, its kind and what is near
void requireKnownInputs(const slam::Wiring& wiring);

/// Refuses one topic for two sensors of the same kind, such as a camera and the rear one: each
/// image would be used twice. @throw slam::ConfigError naming both and the key of the robot file
void requireDistinctTopics(const slam::Wiring& wiring, const TopicsConfig& topics);

}  // namespace slam_ros
