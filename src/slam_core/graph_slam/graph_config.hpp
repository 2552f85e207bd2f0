// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/association/joint_map_config.hpp"
#include "slam_core/common/config_fields.hpp"
#include "slam_core/landmark_graph/associator.hpp"
#include "slam_core/models/calibration.hpp"

namespace slam::graph_slam {

struct GraphConfig : association::JointMapConfig {
  static constexpr const char* kSection = "graph";

  CalibrationConfig calibration;  ///< a section of its own
  double node_distance = 0.05;
  double node_angle = 0.05;
  int nodes_per_place = 40;
  int iterations = 3;
  double insert_distance = 0.4;
  double insert_angle = 0.3;
  double submap_way = 8.0;
  double drift_position = 0.01;
  double drift_heading = 0.002;
  double lost_share = 0.5;

  landmark_graph::AssociationConfig ofAssociation() const {
    return {association, gate_probability, places, mapIsFixed()};
  }
  /// The variance of (x, y, theta) by which scans err for each metre of the way.
  Eigen::Vector3d driftPerMetre() const;
  void describe(Fields& fields);

 private:
  void describeScans(Fields& fields);
};

}  // namespace slam::graph_slam
