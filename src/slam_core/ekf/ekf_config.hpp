// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/association/place_config.hpp"
#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/backend_mode.hpp"
#include "slam_core/models/calibration.hpp"

namespace slam::ekf {

/// Which landmarks an update touches: those of the neighbourhood, or all.
enum class UpdateExtent { kCompressed, kDense };

struct EkfConfig {
  static constexpr const char* kSection = "ekf";

  BackendMode mode = BackendMode::kSlam;
  std::string filter = "extended";
  std::string linearization = "right_invariant";
  int iterations = 5;
  UpdateExtent update = UpdateExtent::kCompressed;
  int neighbourhood = 64;
  std::string association = "known_ids";  ///< the product's, see AssociationChooser
  CalibrationConfig calibration;          ///< a section of its own
  association::PlaceConfig places;
  double gate_probability = 0.9999;
  double initial_sigma_position = 1e-4;
  double initial_sigma_heading = 1e-4;
  double load_inflation = 2.0;
  int joint_limit = 2000;

  bool mapIsFixed() const { return mode == BackendMode::kLocalization; }
  void describe(Fields& fields);
};

}  // namespace slam::ekf
