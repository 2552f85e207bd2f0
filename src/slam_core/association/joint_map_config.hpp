// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/association/place_config.hpp"
#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"

namespace slam::association {

/// The part of the configuration that back-ends share that estimate robot and landmarks as one
/// Gaussian; their own configuration derives from it.
struct JointMapConfig {
  BackendMode mode = BackendMode::kSlam;
  std::string association = "known_ids";  ///< the product's, see AssociationChooser
  PlaceConfig places;
  double gate_probability = 0.9999;
  double initial_sigma_position = 1e-4;
  double initial_sigma_heading = 1e-4;
  double load_inflation = 2.0;
  int joint_limit = 2000;

  bool mapIsFixed() const { return mode == BackendMode::kLocalization; }
  void describe(Fields& fields);
};

}  // namespace slam::association
