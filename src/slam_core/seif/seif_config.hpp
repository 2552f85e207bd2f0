// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/association/joint_map_config.hpp"
#include "slam_core/common/config_fields.hpp"
#include "slam_core/landmark_graph/associator.hpp"

namespace slam::seif {

struct SeifConfig : association::JointMapConfig {
  static constexpr const char* kSection = "seif";

  int active_landmarks = 30;
  int interval_nodes = 100;
  double interval_heading = 0.05;
  double node_distance = 0.05;
  double node_angle = 0.05;
  int iterations = 3;

  landmark_graph::AssociationConfig ofAssociation() const {
    return {association, gate_probability, places, mapIsFixed()};
  }
  void describe(Fields& fields);
};

}  // namespace slam::seif
