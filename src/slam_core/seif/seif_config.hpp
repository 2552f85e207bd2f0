// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"
#include "slam_core/landmark_graph/associator.hpp"

namespace slam::seif {

struct SeifConfig {
  static constexpr const char* kSection = "seif";

  BackendMode mode = BackendMode::kSlam;
  std::string association = "known_ids";  ///< the product's, see AssociationChooser
  association::PlaceConfig places;
  double gate_probability = 0.9999;
  double initial_sigma_position = 1e-4;
  double initial_sigma_heading = 1e-4;
  double load_inflation = 2.0;
  int joint_limit = 2000;
  int active_landmarks = 30;
  int interval_nodes = 100;
  double interval_heading = 0.05;
  double node_distance = 0.05;
  double node_angle = 0.05;
  int iterations = 3;

  bool mapIsFixed() const { return mode == BackendMode::kLocalization; }
  landmark_graph::AssociationConfig ofAssociation() const {
    return {association, gate_probability, places, mapIsFixed()};
  }
  void describe(Fields& fields);
};

}  // namespace slam::seif
